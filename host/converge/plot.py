#!/usr/bin/env python3
"""Draws error against time from points.csv and summary.json of a folder made by `pencil converge`.

    python3 plot.py FOLDER      writes FOLDER/plots/{relative_error,rmse,lab_rms}-{light,dark}.svg

Exit status 3: matplotlib is missing.
"""
import csv
import json
import os
import statistics
import sys

try:
    import matplotlib

    matplotlib.use("svg")
    import matplotlib.pyplot as plt
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
except ImportError:
    sys.exit(3)

THEMES = {
    "light": {"ink": "#1f2328", "faint": "#59636e", "grid": "#d8dee4", "base": "#333a41"},
    "dark": {"ink": "#e6edf3", "faint": "#9198a1", "grid": "#30363d", "base": "#d1d7de"},
}
COLOURS = ["#0a84d6", "#e0701a", "#149f78", "#c05fa8", "#b08a00", "#7a6ff0"]  # as in page_tables.cpp
MARKERS = ["s", "o", "^", "D", "v", "P", "X"]
METRICS = {  # key: (label, factor, unit)
    "relative_error": ("relative error, sqrt(relMSE)", 100.0, " %"),
    "rmse": ("RMSE", 1.0, ""),
    "lab_rms": ("L*a*b* RMS", 1.0, ""),
}
VERDICT_TIMES = [0.1, 1, 10]


def error_of(row, metric, noise):
    """The relative error is without the noise of the reference, as in summary.cpp (above_reference_noise)."""
    if metric != "relative_error":
        return float(row[metric])
    rel_mse = float(row["rel_mse"])
    return max(rel_mse - noise, 0.05 * rel_mse) ** 0.5


def curve(rows, metric, noise):
    """Per budget: median time, root mean square of the error over the seeds."""
    points = []
    for budget in sorted({int(row["budget"]) for row in rows}):
        runs = [row for row in rows if int(row["budget"]) == budget]
        time = statistics.median(float(run["seconds"]) for run in runs)
        error = (sum(error_of(run, metric, noise) ** 2 for run in runs) / len(runs)) ** 0.5
        points.append((time, error))
    return sorted(points)


def plain(value, unit=""):
    return f"{value:.10f}".rstrip("0").rstrip(".") + unit


def style_axes(axes, theme, unit):
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.grid(True, which="major", color=theme["grid"], linewidth=0.8)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(theme["grid"])
    axes.tick_params(which="both", colors=theme["faint"], length=0)
    axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: plain(x, " s")))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: plain(y, unit)))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("time, wall clock without kernel builds", color=theme["faint"])


def draw(summary, rows, metric, theme, file):
    label, factor, unit = METRICS[metric]
    main = metric == "relative_error"  # the large plot; the small ones beside each other share its legend
    figure, axes = plt.subplots(figsize=(7.6, 4.3) if main else (5.0, 3.9))
    style_axes(axes, theme, unit)
    axes.set_title(label, loc="left", color=theme["ink"], fontsize=11)
    for time in VERDICT_TIMES:
        axes.axvline(time, color=theme["faint"], linewidth=0.7, linestyle=(0, (2, 3)), zorder=1)
    noise = summary["reference"]["noise_rel_mse"] or 0.0
    for index, method in enumerate(summary["methods"]):
        mine = [row for row in rows if row["method"] == method["name"]]
        points = [(t, factor * e) for t, e in curve(mine, metric, noise) if e > 0]
        if not points:
            continue
        colour = theme["base"] if index == 0 else COLOURS[(index - 1) % len(COLOURS)]
        marker = MARKERS[index % len(MARKERS)]
        axes.plot([float(r["seconds"]) for r in mine], [factor * error_of(r, metric, noise) for r in mine], marker, color=colour, alpha=0.3,
                  markersize=3, linestyle="none")
        axes.plot(*zip(*points), marker=marker, color=colour, markersize=5.5, linewidth=2, linestyle="--" if index == 0 else "-",
                  label=method["name"], zorder=3)
        fit = method["fits"][metric]
        if fit["floor_visible"]:
            axes.axhline(factor * fit["floor"], color=colour, linewidth=1, linestyle=":", zorder=2)
    if main and noise > 0:
        axes.axhline(factor * noise ** 0.5, color=theme["faint"], linewidth=1, linestyle="-.", label="noise of the reference")
    low, high = axes.get_ylim()
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if high > 8 * low else (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)))
    if main:
        axes.legend(frameon=False, labelcolor=theme["ink"], loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=9.5)
    figure.savefig(file, transparent=True, bbox_inches="tight", metadata={"Date": None})
    plt.close(figure)


def main(folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as stream:
        summary = json.load(stream)
    with open(os.path.join(folder, "points.csv"), newline="", encoding="utf-8") as stream:
        rows = [row for row in csv.DictReader(stream) if int(row["seed"]) < summary["seeds"]]
    os.makedirs(os.path.join(folder, "plots"), exist_ok=True)
    plt.rcParams.update({"font.family": "sans-serif", "font.size": 10, "svg.hashsalt": "pencil"})
    for metric in METRICS:
        for name, theme in THEMES.items():
            draw(summary, rows, metric, theme, os.path.join(folder, "plots", f"{metric}-{name}.svg"))


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else ".")
