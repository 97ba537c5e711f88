#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run time against error: results.csv to docs/figures/precision-tiers.svg."""

import csv
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

HERE = pathlib.Path(__file__).resolve().parent
COLOURS = {"double": "#d95f02", "interval": "#7570b3", "filtered": "#1b9e77", "exact": "#444444"}
MARKERS = {"double": "v", "interval": "s", "filtered": "o", "exact": "D"}


def read(path):
    with open(path) as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def main():
    source = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "results.csv"
    target = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else HERE / "../../docs/figures/precision-tiers.svg"
    rows = read(source)
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    base = {row["scene"]: float(row["cpu_ms"]) for row in rows if row["arithmetic"] == "filtered"}
    edges = {row["scene"]: int(row["edges"]) for row in rows if row["arithmetic"] == "exact"}

    plt.rcParams.update({"font.size": 8, "svg.hashsalt": "sightline", "svg.fonttype": "none"})
    figure, (time, error) = plt.subplots(1, 2, sharey=True, figsize=(8.5, 0.19 * len(scenes) + 1.2))
    for row in rows:
        y, kind = scenes.index(row["scene"]), row["arithmetic"]
        style = {"color": COLOURS[kind], "marker": MARKERS[kind], "linestyle": "none", "markersize": 4.5}
        time.plot(float(row["cpu_ms"]) / base[row["scene"]], y, **style)
        wrong = int(row["false"]) + int(row["missed"])
        if wrong:
            error.plot(wrong / edges[row["scene"]], y, **style)
    for kind, colour in COLOURS.items():
        time.plot([], [], color=colour, marker=MARKERS[kind], linestyle="none", markersize=4.5, label=kind)
    time.set_yticks(range(len(scenes)), scenes)
    time.invert_yaxis()
    time.set_xscale("log")
    time.set_xlabel("processor time / that of filtered")
    error.set_xscale("log")
    error.set_xlabel("wrong edges / right edges (no mark: none is wrong)")
    for axes in (time, error):
        axes.grid(alpha=0.3, linewidth=0.5)
    time.legend(loc="upper center", bbox_to_anchor=(1.0, 1.09), ncol=4, frameon=False)
    target.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(target, bbox_inches="tight", metadata={"Date": None})
    if target.suffix == ".svg" and len(sys.argv) > 3:
        figure.savefig(sys.argv[3], bbox_inches="tight", dpi=80)


if __name__ == "__main__":
    main()
