"""Figures 6.6 and 6.8 of the thesis: crops of each artefact with its error, ours and after each remedy; maps of pencils as pictures.

    /usr/bin/python3 scripts/thesis/artefacts.py [--reference FILE.exr]    # draws docs/images/thesis/ and prints the tables

scripts/thesis_results.sh makes them with all others."""
import argparse
import pathlib
import subprocess

import matplotlib.pyplot as plt
import numpy

import plots
import runs

# Regions of figure 6.6 in the image of 512 x 512: name, left, top, side [pixels].
REGIONS = [
    ("1: corner", 96, 352, 96),
    ("2: few pencils in view", 160, 288, 96),
    ("3: both", 272, 320, 128),
    ("4: penumbra", 376, 384, 96),
]
# Columns: name, options. The first is what the artefacts are of.
FORMS = [
    ("lines", ["--method", "line", "--pencils", 128]),
    ("denser near surfaces", ["--method", "line", "--pencils", 128, "--placement", "random+near-surface"]),
    ("maps of 16 texels", ["--method", "line", "--pencils", 128, "--map", 16]),
    ("Voronoi cells", ["--method", "line", "--pencils", 128, "--weights", "voronoi"]),
    ("512 pencils", ["--method", "line", "--pencils", 512, "--iterate", "levels"]),
    ("16 rays beside lines", ["--method", "hybrid", "--pencils", 128, "--rays", 16]),
    ("64 rays beside lines", ["--method", "hybrid", "--pencils", 128]),
]
FIELD_PENCILS = 64  # of which two are shown


def crop(pixels, region):
    _, left, top, side = region
    return pixels[top:top + side, left:left + side]


def render(name, arguments, device):
    output = runs.WORK / f"artefact-{name}.exr"
    chosen = ["--device", device] if device else []
    runs.run(runs.PENCIL, "render", runs.SCENE, "-o", output, "--light-samples", 200, "--resolution", "512x512", "--aov", "none", "--quiet",
             *arguments, *chosen)
    return output


def errors(pixels, truth, exposure):
    """(L*a*b* RMS, ratio of means) of a crop."""
    distance = plots.lab(pixels, exposure) - plots.lab(truth, exposure)
    return float(numpy.sqrt((distance**2).sum(axis=-1).mean())), float(pixels.mean() / truth.mean())


def draw(name, columns, exposure):
    """Crops in rows of regions; columns: (title, image, errors by region or None)."""
    figure, axes = plt.subplots(len(REGIONS), len(columns), figsize=(1.15 * len(columns), 1.35 * len(REGIONS)), layout="constrained")
    for axis_row, region, index in zip(axes, REGIONS, range(len(REGIONS))):
        for axis, (title, pixels, found) in zip(axis_row, columns):
            axis.imshow(plots.display(crop(pixels, region), exposure))
            axis.set_xticks([])
            axis.set_yticks([])
            axis.set_xlabel(f"{found[index][0]:.1f}" if found else "", fontsize=7)
            if index == 0:
                axis.set_title(title, fontsize=7, wrap=True)
        axis_row[0].set_ylabel(region[0], fontsize=7)
    plots.save(figure, name)


def artefacts(truth, options):
    """Figure 6.6. Rows of its table: L*a*b* RMS of each region, and the ratio of means in brackets."""
    truth_pixels = runs.read_layer(truth)
    columns, rows, exposure = [("path tracing", truth_pixels, None)], [], None
    for number, (title, arguments) in enumerate(FORMS):
        image = render(number, arguments, options.device)
        rms, exposure = runs.compare(image, truth)
        pixels = runs.read_layer(image)
        found = [errors(crop(pixels, r), crop(truth_pixels, r), exposure) for r in REGIONS]
        columns.append((title, pixels, found))
        text = " ".join(str(a) for a in arguments)
        rows.append(f"| {title} | `{text}` | {rms:.1f} | " + " | ".join(f"{e:.1f} ({m:.2f})" for e, m in found) + " |")
    draw("artefacts.png", columns, exposure)
    return "\n".join(rows)


def field_maps(options):
    """Figure 6.8: maps of the pencil nearest to the open front of the box, and of the one nearest to its middle."""
    field = runs.WORK / "maps.exr"
    chosen = ["--device", options.device] if options.device else []
    runs.run(runs.PENCIL, "bake", runs.SCENE, "-o", field, "--from", "surface", "--pencils", FIELD_PENCILS, "--map", 128, "--spp", 8, "--quiet",
             *chosen)
    header = subprocess.run(["oiiotool", "--info", "-v", str(field)], check=True, capture_output=True, text=True).stdout
    line = next(text for text in header.splitlines() if "pencil:centres" in text)
    centres = numpy.array([float(v) for v in line.split('"')[1].split()]).reshape(-1, 3)
    pixels = runs.read_layer(field)
    columns = int(numpy.ceil(numpy.sqrt(len(centres))))

    def tile(index):
        row, column = divmod(int(index), columns)
        return pixels[128 * row:128 * (row + 1), 128 * column:128 * (column + 1)]

    low, high = centres.min(axis=0), centres.max(axis=0)
    front, middle = centres[:, 2].argmin(), numpy.abs((centres - (low + high) / 2) / (high - low)).max(axis=1).argmin()
    exposure = 0.8 / numpy.percentile(pixels, 98)
    panels = [(f"({', '.join(f'{c:.0f}' for c in centres[i])})", plots.display(tile(i), exposure)) for i in (front, middle)]
    plots.panel_row("octahedral-maps.png", panels)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--reference", type=pathlib.Path, help="EXR of the path traced Cornell box; without it, one is rendered")
    parser.add_argument("--spp", type=int, default=512, help="paths per pixel of the reference (default 512)")
    parser.add_argument("--device", help="as in `pencil render`")
    options = parser.parse_args()
    runs.WORK.mkdir(parents=True, exist_ok=True)
    print(artefacts(options.reference or runs.reference(options.spp), options))
    field_maps(options)


if __name__ == "__main__":
    main()
