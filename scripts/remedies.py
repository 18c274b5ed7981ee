#!/usr/bin/env python3
"""Measures what remedies for the errors of the line method bring, those that the thesis names (6.4 and chapters 5 and 7) and others.

    scripts/remedies.py build/release/pencil [--seeds 2] [--reference-time 40] [--only WORD] [--keep DIR]

Prints the table of docs/accuracy.md. A remedy is a set of options, or a change of some lines of the kernels, made in a copy of them: what did not help
is no part of the program, but can be measured again. Takes about 30 minutes with the defaults."""

import argparse
import os
import re
import shutil
import tempfile

import numpy
import OpenImageIO

import line_methods

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SCENES = ("cornell-box", "door-ajar")
LINE, HYBRID = "--method line", "--method hybrid"

DENSITY, SMOOTH, VISIBLE = "estimate_density.cl", "smooth_radiance.cl", "lib/packet_visibility.cl"
RAYS, SUM = "project_rays.cl", "sum_rays.cl"


def beta(factor):
    return [(DENSITY, "#define DENSITY_EXPONENT 5.0f", f"#define DENSITY_EXPONENT {5.0 * factor}f")]


GAUSS = [(DENSITY, "for (int k = 0; k < most; ++k) power = select(power, power * power, PACKET_MASK(steps > k));",
          "vfloat angle = acos(power);"
          "power = select(exp(-0.5f * exp2(PACKET_TO_FLOAT(steps)) * angle * angle), (vfloat)(0.0f), PACKET_MASK(power <= 0.0f));")]

# Exponents in proportion to the square of the reciprocal distance to the nearest other centre: lobes as wide as centres lie apart.
BETA_PER_PENCIL = [
    (DENSITY, "    vint steps = PACKET_LOAD(doublings);",
     """    vint steps = PACKET_LOAD(doublings);
    float apart[1024], mean = 0.0f;
    for (int i = 0; i < pencil_count; ++i) {
        apart[i] = INFINITY;
        for (int j = 0; j < pencil_count; ++j)
            if (i != j) apart[i] = fmin(apart[i], distance(cops[i].xyz, cops[j].xyz));
        mean += apart[i] / pencil_count;
    }"""),
    (DENSITY, "for (int k = 0; k < most; ++k)",
     "int more = clamp((int)rint(2.0f * log2(mean / apart[i])), -2, 2); for (int k = 0; k < most + more; ++k)"),
    (DENSITY, "PACKET_MASK(steps > k)", "PACKET_MASK(steps + more > k)")]


def blur(width):
    """Binomial filter of 2 width + 1 texels instead of 3."""
    row = [1.0]
    for _ in range(2 * width):
        row = [a + b for a, b in zip([0.0] + row, row + [0.0])]
    weights = ", ".join(f"{w:.1f}f" for w in row)
    return [(SMOOTH, "#define BINOMIAL_SUM 16.0f", f"#define BINOMIAL_SUM {sum(row) ** 2:.1f}f"),
            (SMOOTH, "float3 sum = (float3)(0.0f);", f"float3 sum = (float3)(0.0f); const float row[{len(row)}] = {{{weights}}};"),
            (SMOOTH, "int dy = -1; dy <= 1;", f"int dy = {-width}; dy <= {width};"),
            (SMOOTH, "int dx = -1; dx <= 1;", f"int dx = {-width}; dx <= {width};"),
            (SMOOTH, "(float)((2 - abs(dx)) * (2 - abs(dy)))", f"row[dx + {width}] * row[dy + {width}]"),
            (SMOOTH, "map_is_inner(centre, n)", f"min(centre.x, centre.y) >= {width} && max(centre.x, centre.y) < n - {width}"),
            (SMOOTH, "map_texel_beside(centre, (int2)(dx, dy), n)", "oct_fold_texel(centre + (int2)(dx, dy), n)")]


SHARP = [(SMOOTH, "if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER) {", "if (1) {")]


def depth_test(bias):
    """The shadow map of the thesis: bilinear reciprocal distance against the surfel's, with a bias."""
    return [(VISIBLE, "    int cells[2 * PENCIL_WIDTH];\n#pragma unroll\n    for (int l = 0; l < PENCIL_WIDTH; ++l) vstore2",
             f"""    int plain = 0;
    for (int l = 0; l < PENCIL_WIDTH; ++l) {{
        global const Hit *h = map->hits + LANE_INT(aimed->f.index, l);
        float fx = LANE_FLOAT(aimed->f.fx, l), fy = LANE_FLOAT(aimed->f.fy, l);
        int row = PENCIL_TILE_STRIDE(map->n);
        float disparity = mix(mix(h[0].disparity, h[1].disparity, fx), mix(h[row].disparity, h[row + 1].disparity, fx), fy);
        float4 d = surfel_position(s, l) - cop;
        if ((fabs(d.x) + fabs(d.y) + fabs(d.z)) * disparity <= 1.0f + {bias}f) plain |= 1 << l;
    }}
    return plain & aimed->faces;
    int cells[2 * PENCIL_WIDTH];
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; ++l) vstore2""")]


# A pencil at infinity is a direction that all surfels share. Rays along it are its map, without texels.
AT_INFINITY = [
    (RAYS, "    vint above = PACKET_MASK(s->plane >= 0);",
     """    int number = row * side + column;
    float height = 1.0f - (2.0f * number + 1.0f) / (side * side), across = sqrt(1.0f - height * height);
    float turn = 2.399963f * number + seed * 1e-9f;
    dx = across * cos(turn), dy = across * sin(turn), dz = height;
    *x = fma(dx, fma(sign * s->nx * s->nx, k, (vfloat)(1.0f)), fma(dy, sign * m, dz * -sign * s->nx));
    *y = fma(dx, m, fma(dy, fma(s->ny * s->ny, k, sign), dz * -s->ny));
    vint above = PACKET_MASK(s->plane >= 0) & PACKET_MASK(fma(s->nx, dx, fma(s->ny, dy, s->nz * dz)) > 0.0f);"""),
    (RAYS, "static inline LaneRays surfel_rays(const SurfelPacket *s,", "static inline LaneRays surfel_rays(uint seed, const SurfelPacket *s,"),
    (RAYS, "surfel_rays(&s, key,", "surfel_rays(seed, &s, key,"),
    (RAYS, "cell_radius(FREE_PATH_DENSITY(path, volume), cosine,", "cell_radius(FREE_PATH_DENSITY(path, volume), (vfloat)(0.25f),"),
    (SUM, "found += select((vfloat)(0.0f), (vfloat)(1.0f), known);",
     """vfloat tx = PACKET_LOAD(ray + (size_t)RAY_TANGENT * ray_capacity), ty = PACKET_LOAD(ray + (size_t)RAY_BITANGENT * ray_capacity);
        vfloat z = sqrt(fmax(1.0f - tx * tx - ty * ty, (vfloat)(0.0f)));
        found += select((vfloat)(0.0f), z, known);"""),
    (SUM, "fmax(found, (vfloat)(1.0f))", "fmax(found, (vfloat)(1e-6f))"),
    *((SUM, f"PACKET_LOAD(ray + (size_t)RAY_{c} * ray_capacity), known)", f"z * PACKET_LOAD(ray + (size_t)RAY_{c} * ray_capacity), known)")
      for c in "RGB")]

REMEDIES = {
    "none": (LINE, []),
    "denser near surfaces: half of the centres there": (LINE + " --placement lds+near-surface", []),
    "denser where light goes": (LINE + " --placement lds+light-rays+camera-rays", []),
    "denser by the illumination profile": (LINE + " --placement profile", []),
    "fields not blurred": (LINE, SHARP),
    "blurred over 5 texels": (LINE, blur(2)),
    "blurred over 9 texels": (LINE, blur(4)),
    "maps of 32 texels": (LINE + " --map 32", []),
    "maps of 128 texels": (LINE + " --map 128", []),
    "a quarter of the exponents": (LINE, beta(0.25)),
    "half the exponents": (LINE, beta(0.5)),
    "twice the exponents": (LINE, beta(2)),
    "four times the exponents": (LINE, beta(4)),
    "exponents per pencil": (LINE, BETA_PER_PENCIL),
    "Gaussian basis (5.27)": (LINE, GAUSS),
    "plain depth test, bias 0.2 %": (LINE, depth_test(0.002)),
    "plain depth test, bias 1 %": (LINE, depth_test(0.01)),
    "plain depth test, bias 5 %": (LINE, depth_test(0.05)),
    "Voronoi cells": (LINE + " --weights voronoi", []),
    "free path": (LINE + " --weights analytic", []),
    "144 pencils at infinity beside lines": (HYBRID + " --rays 144", AT_INFINITY),
    "16 rays beside lines": (HYBRID + " --rays 16", []),
    "64 rays beside lines": (HYBRID, []),
}


def changed_kernels(edits, folder):
    kernels = os.path.join(folder, "kernels")
    shutil.rmtree(kernels, ignore_errors=True)
    shutil.copytree(os.path.join(ROOT, "kernels"), kernels)
    for name, before, after in edits:
        path = os.path.join(kernels, name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        if before not in text:
            raise SystemExit(f"{name} has changed; this is no part of it any more: {before}")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(before, after))
    return kernels


def time_of_sets(scene, sets, folder, rounds=3):
    """Least seconds of CPU time of a render that makes so many sets."""
    image, seconds = os.path.join(folder, "image.exr"), []
    for _ in range(rounds):
        before = os.times()
        line_methods.run(line_methods.PENCIL, "render", scene, "-o", image, "--method", "hybrid", "--resolution", f"{line_methods.SIZE}x{line_methods.SIZE}",
                         "--bounces", str(sets + 1), "--quiet")
        after = os.times()
        seconds.append(after.children_user + after.children_system - before.children_user - before.children_system)
    return min(seconds)


def print_termination(scene, folder, trials=400):
    """Squared error that probabilistic termination adds: from an order on a bounce is made by the chance of its ratio q and counts 1 / q times."""
    image = os.path.join(folder, "orders.exr")
    line_methods.run(line_methods.PENCIL, "render", scene, "-o", image, "--method", "hybrid", "--resolution", "96x96", "--tolerance", "1e-4", "--quiet")
    file = OpenImageIO.ImageInput.open(image)
    names, pixels = file.spec().channelnames, file.read_image(OpenImageIO.FLOAT)
    luminance = numpy.array([0.2126, 0.7152, 0.0722])
    bounces = sorted((name[:-2] for name in names if re.fullmatch(r"(bounce|tail)\d+\.R", name)), key=lambda name: int(re.sub(r"\D", "", name)))
    layers = [sum(w * pixels[..., names.index(f"{layer}.{c}")] for w, c in zip(luminance, "RGB")) for layer in bounces]
    whole = sum(w * pixels[..., names.index(c)] for w, c in zip(luminance, "RGB"))
    random = numpy.random.default_rng(1)
    print("\n| terminated from order | relMSE that it adds | sets made | CPU s |\n|---|---|---|---|")
    for first in (2, 3, 4):
        errors, made = [], []
        for _ in range(trials):
            lost, weight, count = numpy.zeros_like(whole), 1.0, 0
            for k, layer in enumerate(layers):
                chance = layer.mean() / layers[k - 1].mean() if k + 2 > first and weight > 0 else 1.0
                weight = weight / chance if chance == 1.0 or random.random() < chance else 0.0
                lost += (weight - 1.0) * layer
                count += weight > 0
            errors.append(numpy.mean(lost ** 2 / (whole ** 2 + 1e-2 * whole.mean() ** 2)))
            made.append(count)
        seconds = time_of_sets(scene, round(numpy.mean(made)), folder)
        print(f"| {first + 1} | {numpy.mean(errors):.2g} | {numpy.mean(made):.1f} of {len(layers)} | {seconds:.1f} |")
    print(f"| never | | {len(layers)} of {len(layers)} | {time_of_sets(scene, len(layers), folder):.1f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pencil")
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--reference-time", default="40")
    parser.add_argument("--only", default="", help="remedies whose names hold this")
    parser.add_argument("--keep")
    options = parser.parse_args()
    line_methods.PENCIL = os.path.abspath(options.pencil)
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or temporary
        os.makedirs(folder, exist_ok=True)
        print("| remedy | " + " | ".join(f"{scene}: relMSE | mean | seconds" for scene in SCENES) + " | red of the front |")
        print("|---" * (3 * len(SCENES) + 2) + "|")
        for name, (flags, edits) in REMEDIES.items():
            if options.only not in name:
                continue
            os.environ["PENCIL_KERNEL_DIR"] = changed_kernels(edits, folder)
            cells, front = "", 0.0
            for scene_name in SCENES:
                scene, reference = line_methods.truth(scene_name, folder, options.reference_time)
                rows = numpy.array([line_methods.measure(scene, flags, seed, folder, reference) for seed in range(options.seeds)])
                error, mean, _, _, red, seconds = rows.mean(axis=0)
                front = red if scene_name == "cornell-box" else front
                cells += f"{error:.2g} | {mean:.3f} | {seconds:.1f} | "
            print(f"| {name} | {cells}{front:.2f} |", flush=True)
        os.environ.pop("PENCIL_KERNEL_DIR", None)
        if options.only in "probabilistic termination":
            print_termination(line_methods.truth("cornell-box", folder, options.reference_time)[0], folder)


if __name__ == "__main__":
    main()
