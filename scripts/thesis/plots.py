"""Figures of docs/thesis-results.md."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen before)
import numpy  # noqa: E402
from PIL import Image  # noqa: E402

from runs import ROOT  # noqa: E402

IMAGES = ROOT / "docs/images/thesis"
MOST_BYTES = 150_000
PANEL = 256  # pixels along a side of one image in a row


def display(linear, exposure=1.0):
    """sRGB display values in [0, 1]."""
    x = numpy.clip(linear * exposure, 0, 1)
    return numpy.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)


def lab(linear, exposure):
    """CIE L*a*b* (D65) of displayed colours, as `pencil compare` defines it."""
    x = numpy.clip(linear * exposure, 0, 1)
    to_xyz = numpy.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]])
    xyz = x @ (to_xyz / to_xyz.sum(axis=1, keepdims=True)).T
    f = numpy.where(xyz > (6 / 29) ** 3, numpy.cbrt(xyz), xyz * (29 / 6) ** 2 / 3 + 4 / 29)
    return numpy.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], axis=-1)


def shrink(image):
    """Box filter to PANEL pixels along a side."""
    factor = max(image.shape[0] // PANEL, 1)
    rows, columns = image.shape[0] // factor, image.shape[1] // factor
    cut = image[: rows * factor, : columns * factor]
    return cut.reshape(rows, factor, columns, factor, -1).mean(axis=(1, 3)).squeeze()


def save(figure, name):
    """Writes the figure with a palette, so that it stays small; fails if it does not."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    file = IMAGES / name
    figure.savefig(file, dpi=100, facecolor="white")
    plt.close(figure)
    image = Image.open(file).convert("RGB")
    palette = image.quantize(256)  # dithering needs a palette that is there already
    image.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG).save(file, optimize=True)
    if file.stat().st_size > MOST_BYTES:
        raise SystemExit(f"thesis_results: {file} takes {file.stat().st_size} bytes, more than {MOST_BYTES}")


def panel_row(name, panels, bar=None):
    """Images side by side, each (title, [h][w][3] display values, or [h][w] with `bar` = (label, largest value))."""
    extra = 0.5 if bar else 0
    figure, axes = plt.subplots(1, len(panels), figsize=(2.0 * len(panels) + extra, 2.25), layout="constrained")
    shown = None
    for axis, (title, image) in zip(axes, panels):
        shown = axis.imshow(image, **({"cmap": "magma", "vmin": 0, "vmax": bar[1]} if bar else {}))
        axis.set_title(title, fontsize=8)
        axis.set_axis_off()
    if bar:
        figure.colorbar(shown, ax=axes, label=bar[0], shrink=0.9)
    save(figure, name)


def error_curve(name, curves):
    """L*a*b* RMS against pencils; curves: label -> {pencils: [one value per seed]}."""
    figure, axis = plt.subplots(figsize=(6, 3.6), layout="constrained")
    for label, values in curves.items():
        sizes = sorted(values)
        medians = [numpy.median(values[n]) for n in sizes]
        axis.plot(sizes, medians, "o-", label=label)
        axis.fill_between(sizes, [min(values[n]) for n in sizes], [max(values[n]) for n in sizes], alpha=0.2)
    axis.set_xscale("log", base=2)
    axis.set_xticks(sizes, [str(n) for n in sizes])
    axis.set_ylim(bottom=0)
    axis.set_xlabel("pencils of the first set")
    axis.set_ylabel("L*a*b* RMS")
    axis.grid(alpha=0.3)
    axis.legend()
    save(figure, name)


def rate_histograms(name, maps):
    """Shares of the sphere by sampling rate relative to the mean (thesis figure 6.9)."""
    figure, axes = plt.subplots(1, len(maps), figsize=(2.2 * len(maps), 2.3), sharey=True, layout="constrained")
    for axis, entry in zip(axes, maps):
        width = entry["bin_width"]
        axis.bar([(i + 0.5) * width for i in range(len(entry["histogram"]))], [100 * h for h in entry["histogram"]], width=width)
        axis.axvline(1, color="black", linewidth=0.8)
        axis.set_xlim(0, 3)
        axis.set_title(entry["map"], fontsize=9)
        axis.set_xlabel("rate / mean rate")
    axes[0].set_ylabel("% of the sphere")
    save(figure, name)
