"""Regenerates docs/thesis-results.md: what sections 6.3 and 6.3.1 of the thesis show, measured with this program. See thesis_results.sh."""
import argparse
import json
import pathlib
import string
import subprocess

import numpy

import artefacts
import plots
import runs

SIZES = [12, 25, 50, 100]  # table 6.3
# Stages of table 6.3: (name in the thesis, its times for SIZES [s])
TABLE_6_3 = [
    ("Sampling and creation", [0.048, 0.100, 0.472, 0.657]),
    ("Initial gather", [0.247, 0.462, 1.427, 2.297]),
    ("Depth texture render", [0.086, 0.182, 0.676, 1.479]),
    ("DPDF texture render", [0.306, 1.326, 5.167, 17.85]),
    ("Final projection-scatter", [0.007, 0.014, 0.025, 0.045]),
]
TABLE_6_4 = [(25, 12, 0.31), (25, 25, 0.76), (50, 25, 2.98), (100, 50, 10.50)]  # source and target pencils, time [s]
TABLE_6_5 = [("Light depth map acquisition", 0.32), ("Direct illumination rendering", 0.015)]  # 50 light samples
TABLE_6_6 = {"paraboloid": (4.00, 0.44), "cube": (5.19, 0.27), "octahedral": (5.19, 0.26)}  # sampling ratio, variation
THESIS_LOOK_UPS_MS = 11.37  # 6.3.1, octahedral, 128 look-ups per pixel
SERIES = [32, 64, 128]  # figure 6.4
CURVE = [8, 16, 32, 64, 128, 256]  # figure 6.7
SEEDS = [0, 1, 2]
DEPTH_KERNELS = ["rasterize octahedral maps", "fold geometry maps"]
TEMPLATE = pathlib.Path(__file__).with_name("page.md")


def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def seconds(value):
    return f"{value:.3g}" if value < 0.1 else f"{value:.2f}"


def spread(values, digits=2):
    """Median, and in brackets the range, of what seeds give."""
    return f"{numpy.median(values):.{digits}f} ({min(values):.{digits}f} to {max(values):.{digits}f})"


def component_panels(image, layers):
    """Figure 6.3. Returns the factor by which each component is scaled for display: all fill it, as in the thesis."""
    beauty = runs.read_layer(image)
    exposure = 0.8 / numpy.percentile(beauty, 98)
    panels, scales = [], []
    for layer in layers:
        pixels = runs.read_layer(image, layer)
        scales.append(0.8 / numpy.percentile(pixels, 98) / exposure)
        panels.append((f"{layer}, x {scales[-1]:.1f}", plots.shrink(plots.display(pixels, scales[-1] * exposure))))
    panels.append(("all", plots.shrink(plots.display(beauty, exposure))))
    plots.panel_row("bounce-components.png", panels)
    return scales


def bounce_components(truth, options):
    """Table of figure 6.3: sets of 100, 50 and 25 pencils carry the second, third and fourth light bounce. Drawn is the first seed."""
    layers = ["direct", "bounce2", "bounce3", "bounce4"]
    images = [
        runs.render(f"components-{seed}", "--pencils", 100, "--decay", 0.5, "--bounces", 4, "--seed", seed, device=options.device)
        for seed in SEEDS
    ]
    sets = [b["pencils"] for b in images[0][1]["bounces"]]
    if sets != [0, 100, 50, 25]:
        raise SystemExit(f"thesis_results: figure 6.3 needs sets of 100, 50 and 25 pencils, not {sets[1:]}")
    ratios = [runs.mean_ratios(image, truth) for image, _ in images]
    rows = []
    for k, (layer, scale) in enumerate(zip(layers, component_panels(images[0][0], layers))):
        means = numpy.median([stats["bounces"][k]["mean"] for _, stats in images], axis=0)
        over = spread([r[layer] for r in ratios], 3)
        rows.append(row(layer, sets[k] or "50 light samples", *(f"{v:.4f}" for v in means), over, f"{scale:.1f}"))
    return "\n".join(rows)


def lab_distance(image, truth, truth_pixels):
    """(image, its L*a*b* distances from the reference, their RMS, exposure of the display); fails if `pencil compare` says another RMS."""
    rms, exposure = runs.compare(image, truth)
    pixels = runs.read_layer(image)
    distance = numpy.linalg.norm(plots.lab(pixels, exposure) - plots.lab(truth_pixels, exposure), axis=-1)
    if abs(numpy.sqrt((distance**2).mean()) - rms) > 0.01 * rms:
        raise SystemExit(f"thesis_results: the L*a*b* RMS drawn differs from that of `pencil compare`, {rms}")
    return pixels, distance, rms, exposure


def image_series(truth, options):
    """Figures 6.4 and 6.5: images of 32, 64 and 128 pencils and their L*a*b* distances from the reference. Drawn is the first seed."""
    truth_pixels = runs.read_layer(truth)
    images, distances, rows = [], [], []
    for pencils in SERIES:
        found = []
        for seed in SEEDS:
            image, _ = runs.render("series", "--pencils", pencils, "--decay", 0.7, "--seed", seed, device=options.device)
            found.append(lab_distance(image, truth, truth_pixels))
        pixels, distance, _, exposure = found[0]
        images.append((f"{pencils} pencils", plots.shrink(plots.display(pixels, exposure))))
        distances.append((f"{pencils} pencils", plots.shrink(distance)))
        medians, last = ([of(d) for _, d, _, _ in found] for of in (numpy.median, lambda d: numpy.percentile(d, 99)))
        rows.append(row(pencils, spread([rms for _, _, rms, _ in found]), spread(medians), spread(last, 1)))
    images.append(("reference", plots.shrink(plots.display(truth_pixels, exposure))))
    plots.panel_row("image-series.png", images)
    plots.panel_row("image-differences.png", distances, bar=("L*a*b* distance", 30))
    return "\n".join(rows)


def error_curve(truth, options):
    """Figure 6.7, for the quadrature weights of this program and the printed ones."""
    curves = {}
    for weights in ["dpdf", "thesis"]:
        values = {}
        for pencils in CURVE:
            for seed in SEEDS:
                arguments = ["--pencils", pencils, "--decay", 0.7, "--weights", weights, "--seed", seed]
                image, _ = runs.render("curve", *arguments, device=options.device)
                values.setdefault(pencils, []).append(runs.compare(image, truth)[0])
        curves[f"--weights {weights}"] = values
    plots.error_curve("error-curve.png", curves)
    return "\n".join(row(n, *(spread(v[n]) for v in curves.values())) for n in CURVE)


def stage_times(options):
    """Table 6.3. Returns its rows and the statistics of one render."""

    def measure(stats):
        maps = runs.stage(stats, "pencil maps")
        depth = sum(maps["kernel_launches"][k]["device_seconds"] for k in DEPTH_KERNELS)
        wall = [runs.stage(stats, s)["wall_seconds"] for s in ("initial gather", "pencil density", "projection-scatter")]
        return [maps["wall_seconds"] - depth, wall[0], depth, wall[1], wall[2]]

    columns = []
    for size in SIZES:
        times, stats = runs.least_times(options.repeats, "times", ["--pencils", size, "--bounces", 2], measure, options.device)
        columns.append(times)
    rows = []
    for index, (name, printed) in enumerate(TABLE_6_3):
        cells = (f"{p:.3f} / {seconds(column[index])}" for p, column in zip(printed, columns))
        rows.append(row(name, *cells))
    return "\n".join(rows), stats


def transport_times(options):
    """Table 6.4."""
    rows = []
    for source, target, printed in TABLE_6_4:
        arguments = ["--pencils", source, "--decay", target / source, "--least-pencils", 1, "--bounces", 3]
        (time,), stats = runs.least_times(
            options.repeats, "times", arguments, lambda s: [runs.stage(s, "pencil transport")["wall_seconds"]], options.device
        )
        sets = [b["pencils"] for b in stats["bounces"]][1:]
        if sets != [source, target]:
            raise SystemExit(f"thesis_results: table 6.4 needs sets of {source} and {target} pencils, not {sets}")
        rows.append(row(f"{source} -> {target}", f"{printed:.2f}", seconds(time)))
    return "\n".join(rows)


def direct_times(options):
    """Table 6.5."""
    names = ["light sample maps", "direct light"]
    times, _ = runs.least_times(
        options.repeats, "times", ["--bounces", 1], lambda s: [runs.stage(s, n)["wall_seconds"] for n in names], options.device
    )
    return "\n".join(row(name, printed, seconds(time)) for (name, printed), time in zip(TABLE_6_5, times))


def map_study(options):
    """Table 6.6, figure 6.9 and the look-ups of 6.3.1."""
    output = runs.WORK / "map-study.json"
    runs.run(runs.MAP_STUDY, "-o", output, *(["--device", options.device] if options.device else []))
    study = json.loads(output.read_text())
    maps = {m["map"]: m for m in study["maps"]}
    plots.rate_histograms("sampling-rates.png", [maps[m] for m in ("octahedral", "cube", "paraboloid", "pyramid")])
    rates, look_ups = [], []
    base = maps["octahedral"]["least_look_up_seconds"]
    for name, m in maps.items():
        printed = TABLE_6_6.get(name, ("", ""))
        ours = (f"{m[key]:.2f}" for key in ("ratio", "variation_sphere", "variation_texels", "deviation"))
        rates.append(row(name, f"{100 * m['used']:.1f} %", *(f"{p:.2f}" if p else "-" for p in printed), *ours))
        times = (f"{1e3 * m[key]:.0f}" for key in ("look_up_seconds", "least_look_up_seconds", "least_footprint_seconds"))
        size = f"{m['tiles']} x {m['tile_size']}^2"
        relative = f"{m['least_look_up_seconds'] / base:.2f}"
        look_ups.append(row(name, size, *times, relative, f"{100 * m['difference_from_octahedral']:.1f} %"))
    return study, "\n".join(rates), "\n".join(look_ups)


def stages(options, values):
    values["table_6_3"], stats = stage_times(options)
    values["table_6_4"], values["table_6_5"] = transport_times(options), direct_times(options)
    values.update(repeats=options.repeats, device=stats["device"]["name"], units=stats["device"]["compute_units"])
    values.update(film_surfels=stats["film_surfels"], version=stats["version"])


def maps(options, values):
    study, values["table_6_6"], values["look_ups"] = map_study(options)
    values.update(look_up_surfels=study["surfels"], look_up_repeats=study["repeats"], thesis_look_ups=THESIS_LOOK_UPS_MS)


def figures(options, values):
    truth = options.reference or runs.reference(options.spp)
    values.update(spp=options.spp, seeds=len(SEEDS))
    values["components"], values["series"] = bounce_components(truth, options), image_series(truth, options)
    values["curve"] = error_curve(truth, options)


def crops(options, values):
    values["artefacts"] = artefacts.artefacts(options.reference or runs.reference(options.spp), options)
    artefacts.field_maps(options)


PARTS = {"stages": stages, "maps": maps, "figures": figures, "artefacts": crops}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--reference", type=pathlib.Path, help="EXR of the path traced Cornell box; without it, one is rendered")
    parser.add_argument("--spp", type=int, default=512, help="paths per pixel of the reference (default 512)")
    parser.add_argument("--repeats", type=int, default=5, help="renders of which the least time counts (default 5)")
    parser.add_argument("--device", help="as in `pencil render`")
    parser.add_argument("--only", nargs="+", choices=PARTS, default=list(PARTS), help="parts to be made anew; others are those of the last run")
    options = parser.parse_args()
    runs.WORK.mkdir(parents=True, exist_ok=True)
    kept = runs.WORK / "values.json"
    values = json.loads(kept.read_text()) if kept.exists() else {}
    for part in options.only:
        PARTS[part](options, values)
        kept.write_text(json.dumps(values))
    page = string.Template(TEMPLATE.read_text()).substitute(values)
    (runs.ROOT / "docs/thesis-results.md").write_text(page)
    print("thesis_results: wrote docs/thesis-results.md")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"thesis_results: status {error.returncode} of {' '.join(map(str, error.cmd))}") from error
