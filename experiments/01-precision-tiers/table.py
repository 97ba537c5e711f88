#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of docs/exactness.md from results.csv: table.py [RESULTS.csv]"""

import csv
import pathlib
import sys

LEFT_OUT = ("dense rotated 17.3 deg", "dense scaled 0.1", "dense shifted 1e8/3", "floor_plan scaled 0.1",
            "floor_plan shifted 1e8/3", "slivers", "collinear_bodies")
POLICIES = ("double", "interval", "filtered", "exact")


def wrong(row):
    if row["false"] == row["missed"] == "0":
        return "–"
    return f"{int(row['false']):,} / {int(row['missed']):,}"


def main():
    default = pathlib.Path(__file__).resolve().parent / "results.csv"
    scenes = {}
    with open(sys.argv[1] if len(sys.argv) > 1 else default) as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            scenes.setdefault(row["scene"], {})[row["arithmetic"]] = row
    head = ["scene", "edges", "double: false / missed", "interval: false / missed", "interval: undecided",
            "filtered: by filter / interval / exact", *(f"ms {policy}" for policy in POLICIES)]
    print("| " + " | ".join(head) + " |")
    print("| " + " | ".join("---" for _ in head) + " |")
    for scene, by in scenes.items():
        if scene in LEFT_OUT:
            continue
        tiers = " / ".join(f"{int(by['filtered'][tier]):,}" for tier in ("filter", "interval", "exact"))
        times = [f"{float(by[policy]['cpu_ms']):.2f}" for policy in POLICIES]
        cells = [scene, f"{int(by['exact']['edges']):,}", wrong(by["double"]), wrong(by["interval"]),
                 f"{int(by['interval']['undecided']):,}", tiers, *times]
        print("| " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
