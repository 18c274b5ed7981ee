#!/usr/bin/env python3
"""Turns the JSON of the microbenchmarks into markdown tables, and puts them between the markers of a document."""
import argparse
import json
import statistics
import sys

KERNEL_MARKERS = ("<!-- begin: scripts/bench.sh --update-docs -->", "<!-- end -->")
PATH_MARKERS = ("<!-- begin: scripts/bench.sh --benchmark_filter=visibility_paths --update-docs -->", "<!-- end: visibility_paths -->")
COUNTERS = ("items_per_second", "native_items_per_second", "ratio", "bytes_per_second")
PATHS = "visibility_paths/"


def iterations(report, paths):
    """(name, run) of the lines of visibility_paths, or of all others."""
    for run in report["benchmarks"]:
        if run["run_type"] != "iteration" or run["run_name"].startswith(PATHS) != paths:
            continue
        if run.get("error_message", "").startswith("no images"):
            continue
        if run.get("error_occurred"):
            sys.exit(f"bench_table: {run['name']}: {run['error_message']}")
        yield run["run_name"].replace("/manual_time", ""), run


def read_lines(report):
    """{name: (size, {counter: list over repetitions})}, in order of first appearance."""
    lines = {}
    for name, run in iterations(report, False):
        size, values = lines.setdefault(name, (run["label"], {c: [] for c in COUNTERS}))
        for counter in COUNTERS:
            values[counter].append(run[counter])
    return lines


def circumstances(context):
    yield f"{context['date'][:10]}, {context['device']}, packets of {context['packet_width']}."
    yield f"Load average at the start: {context['load_avg'][0]:.1f} on {context['num_cpus']} cores; well above 0, others took part of the rates."


def digits(value):
    """Three digits, all of those before the point."""
    return f"{value:.3g}" if value < 999.5 else f"{value:.0f}"


def path_table(report):
    """Milliseconds of each path for each scene and batch, medians over repetitions; nothing if there are none."""
    rows, prepare = {}, {}
    for name, run in iterations(report, True):
        _, scene, batch, path = name.split("/")
        rows.setdefault((scene, batch), {}).setdefault(path, []).append(run["real_time"])
        prepare.setdefault((scene, path), run["prepare"] * 1e3)
    if not rows:
        return
    yield from circumstances(report["context"])
    yield f"Medians of {max(len(times) for row in rows.values() for times in row.values())} repetitions [ms]; with preparation in brackets."
    yield ""
    paths = list(next(iter(rows.values())))
    yield "| scene | maps | " + " | ".join(paths) + " |"
    yield "|---|---|" + "---:|" * len(paths)
    for (scene, batch), row in rows.items():
        cells = []
        for path in paths:
            time = statistics.median(row[path])
            total = time + prepare[scene, path]
            cells.append(f"{digits(time)}" + (f" ({digits(total)})" if total > time else ""))
        yield f"| {scene} | {batch.replace('x', ' of ')}x{batch.split('x')[1]} | " + " | ".join(cells) + " |"


def table(report):
    context, lines = report["context"], read_lines(report)
    if not lines:
        return
    repetitions = max(len(values["ratio"]) for _, values in lines.values())
    yield from circumstances(context)
    yield f"Native: {context['native_compiler']}, {context['native_threads']} threads. Medians of {repetitions} repetitions."
    yield ""
    yield "| kernel | size | kernel Mop/s | native Mop/s | ratio | least, greatest | GB/s |"
    yield "|---|---|---:|---:|---:|---:|---:|"
    for name, (size, values) in lines.items():
        middle = {counter: statistics.median(v) for counter, v in values.items()}
        spread = f"{min(values['ratio']):.2f}, {max(values['ratio']):.2f}"
        yield (f"| {name} | {size} | {middle['items_per_second'] / 1e6:.0f} | {middle['native_items_per_second'] / 1e6:.0f} "
               f"| {middle['ratio']:.2f} | {spread} | {middle['bytes_per_second'] / 1e9:.1f} |")


def put_into(document, markers, text):
    begin, end = markers
    with open(document, encoding="utf-8") as file:
        before = file.read()
    if before.count(begin) != 1 or before.count(end) != 1:
        sys.exit(f"bench_table: {document} must hold one line \"{begin}\" and one \"{end}\"")
    head, rest = before.split(begin)
    with open(document, "w", encoding="utf-8") as file:
        file.write(f"{head}{begin}\n{text}{end}{rest.split(end)[1]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("json")
    parser.add_argument("-o", dest="output", required=True, help="markdown file")
    parser.add_argument("--docs", help="document to put the table into")
    options = parser.parse_args()
    with open(options.json, encoding="utf-8") as file:
        report = json.load(file)
    tables = [(markers, "\n".join(lines) + "\n") for markers, lines in
              ((KERNEL_MARKERS, list(table(report))), (PATH_MARKERS, list(path_table(report)))) if lines]
    with open(options.output, "w", encoding="utf-8") as file:
        file.write("\n".join(text for _, text in tables))
    if options.docs:
        for markers, text in tables:
            put_into(options.docs, markers, text)


if __name__ == "__main__":
    main()
