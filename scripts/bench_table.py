#!/usr/bin/env python3
"""Turns the JSON of the microbenchmarks into a markdown table, and puts it between the markers of a document."""
import argparse
import json
import statistics
import sys

BEGIN, END = "<!-- begin: scripts/bench.sh --update-docs -->", "<!-- end -->"
COUNTERS = ("items_per_second", "native_items_per_second", "ratio", "bytes_per_second")


def read_lines(report):
    """{name: (size, {counter: list over repetitions})}, in order of first appearance."""
    lines = {}
    for run in report["benchmarks"]:
        if run["run_type"] != "iteration":
            continue
        if run.get("error_occurred"):
            sys.exit(f"bench_table: {run['name']}: {run['error_message']}")
        name = run["run_name"].replace("/manual_time", "")
        size, values = lines.setdefault(name, (run["label"], {c: [] for c in COUNTERS}))
        for counter in COUNTERS:
            values[counter].append(run[counter])
    return lines


def table(report):
    context, lines = report["context"], read_lines(report)
    repetitions = max(len(values["ratio"]) for _, values in lines.values())
    yield f"{context['date'][:10]}, {context['device']}, packets of {context['packet_width']}."
    yield f"Load average at the start: {context['load_avg'][0]:.1f} on {context['num_cpus']} cores; well above 0, others took part of both rates."
    yield f"Native: {context['native_compiler']}, {context['native_threads']} threads. Medians of {repetitions} repetitions."
    yield ""
    yield "| kernel | size | kernel Mop/s | native Mop/s | ratio | least, greatest | GB/s |"
    yield "|---|---|---:|---:|---:|---:|---:|"
    for name, (size, values) in lines.items():
        middle = {counter: statistics.median(v) for counter, v in values.items()}
        spread = f"{min(values['ratio']):.2f}, {max(values['ratio']):.2f}"
        yield (f"| {name} | {size} | {middle['items_per_second'] / 1e6:.0f} | {middle['native_items_per_second'] / 1e6:.0f} "
               f"| {middle['ratio']:.2f} | {spread} | {middle['bytes_per_second'] / 1e9:.1f} |")


def put_into(document, text):
    with open(document, encoding="utf-8") as file:
        before = file.read()
    if before.count(BEGIN) != 1 or before.count(END) != 1:
        sys.exit(f"bench_table: {document} must hold one line \"{BEGIN}\" and one \"{END}\"")
    head, rest = before.split(BEGIN)
    with open(document, "w", encoding="utf-8") as file:
        file.write(f"{head}{BEGIN}\n{text}{END}{rest.split(END)[1]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("json")
    parser.add_argument("-o", dest="output", required=True, help="markdown file")
    parser.add_argument("--docs", help="document to put the table into")
    options = parser.parse_args()
    with open(options.json, encoding="utf-8") as file:
        text = "\n".join(table(json.load(file))) + "\n"
    with open(options.output, "w", encoding="utf-8") as file:
        file.write(text)
    if options.docs:
        put_into(options.docs, text)


if __name__ == "__main__":
    main()
