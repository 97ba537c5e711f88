#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Run every experiment and benchmark: experiments/replicate.sh [BUILD [MAPS [OUT]]]
# BUILD: a build of preset release or bench. MAPS: the folder of 02-maps2d's maps; left out without one.
# OUT: where results go; by default into the experiments' folders, replacing the committed ones.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=${1:-$here/../build/release}
maps=${2:-}
out=${3:-$here}
mkdir -p "$out/01-precision-tiers" "$out/02-maps2d/results" "$out/03-graph-scaling" "$out/04-transversals" "$out/bench/results"

"$build/experiments/01-precision-tiers" --out "$out/01-precision-tiers/results.csv"
if command -pv python3 >/dev/null && "$(command -pv python3)" -c 'import matplotlib' 2>/dev/null; then
    figure=$out/01-precision-tiers/precision-tiers.svg
    [ "$out" = "$here" ] && figure=$here/../docs/figures/precision-tiers.svg
    "$(command -pv python3)" "$here/01-precision-tiers/plot.py" "$out/01-precision-tiers/results.csv" "$figure"
fi
"$build/experiments/03-graph-scaling" --out "$out/03-graph-scaling/results.csv"
# Known inputs are read when the folder of maps lies beside them.
if [ -n "$maps" ] && [ -d "$maps/../lts" ]; then
    "$build/experiments/04-transversals" --data "$maps/.." --out "$out/04-transversals/results.csv"
else
    "$build/experiments/04-transversals" --out "$out/04-transversals/results.csv"
fi
if [ -n "$maps" ]; then
    "$build/experiments/02-maps2d" --data "$maps" --out "$out/02-maps2d/results"
fi
mkdir -p "$out/06-skeleton-size"
"$build/experiments/06-skeleton-size" --out "$out/06-skeleton-size"
for bench in bench_geom bench_planar; do
    "$build/bin/$bench" --benchmark_out="$out/bench/results/$bench.json"
done
