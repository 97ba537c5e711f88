#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compare two runs of a benchmark program, base against head.

    build/base/bin/bench_planar --benchmark_out=base.json
    build/head/bin/bench_planar --benchmark_out=head.json
    experiments/bench/compare.py base.json head.json [--yardstick cgal_view/dense/1000] [--limit 1.10]

Times are processor times (elapsed for names that end in real_time).
With a yardstick, each run's times are divided by its own time of that benchmark, so that runs on machines
of different speed can be compared.
Exit status 1 when a benchmark got slower than the limit.
"""

import argparse
import json
import math
import statistics
import sys


def load(path):
    with open(path) as file:
        runs = json.load(file)["benchmarks"]
    times = {}
    for run in runs:
        if run.get("run_type") == "aggregate" or run.get("error_occurred"):
            continue
        key = "real_time" if run["name"].endswith("real_time") else "cpu_time"
        unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}[run["time_unit"]]
        times.setdefault(run["name"], []).append(run[key] * unit)
    return {name: statistics.median(values) for name, values in times.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("base")
    parser.add_argument("head")
    parser.add_argument("--yardstick", help="name of the benchmark that both runs are divided by")
    parser.add_argument("--limit", type=float, default=1.10, help="largest ratio head / base that passes")
    options = parser.parse_args()

    base, head = load(options.base), load(options.head)
    scale = 1.0
    if options.yardstick:
        scale = base[options.yardstick] / head[options.yardstick]
        print(f"yardstick: head's machine at {1 / scale:.2f} of base's time")
    common = [name for name in base if name in head]
    if not common:
        sys.exit("no benchmark is in both files")
    width = max(map(len, common))
    ratios = {name: head[name] * scale / base[name] for name in common}
    print(f"{'benchmark':{width}}  {'base s':>10}  {'head s':>10}  ratio")
    for name in common:
        mark = "  slower" if ratios[name] > options.limit else ""
        print(f"{name:{width}}  {base[name]:10.3e}  {head[name]:10.3e}  {ratios[name]:5.2f}{mark}")
    mean = math.exp(statistics.fmean(map(math.log, ratios.values())))
    print(f"geometric mean {mean:.3f} over {len(common)}; only in one file: {len(set(base) ^ set(head))}")
    return int(any(ratio > options.limit for ratio in ratios.values()))


if __name__ == "__main__":
    sys.exit(main())
