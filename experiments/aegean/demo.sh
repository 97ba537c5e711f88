#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The main job on a real map: a ship's route through the Aegean islands.
# Usage: experiments/aegean/demo.sh [SIGHTLINE [OUT_FOLDER]]   (called by `make demo`)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
sightline=${1:-$root/build/release/bin/sightline}
out=${2:-$root/out/aegean}
map=$here/aegean.geojson
mkdir -p "$out"

run() {
    echo "+ sightline $*"
    "$sightline" "$@"
}

run info "$map" --world -o "$out/info.json"
run graph "$map" --world -o "$out/graph.json" --vtk "$out/graph.vtp" --svg "$out/graph.svg"
run graph "$map" --world --tangent -o "$out/tangent.json"

# One line a route: name, from, to; numbers as they stand in ports.json.
python3 "$here/summary.py" --routes "$here/ports.json" > "$out/routes.txt"
while read -r name from to; do
    run path "$map" --world "--from=$from" "--to=$to" -o "$out/$name.json" \
        --vtk "$out/$name.vtp" --svg "$out/$name.svg"
    run render "$map" --world "$out/$name.json" --png "$out/$name.png"
done < "$out/routes.txt"

python3 "$here/summary.py" "$out"
