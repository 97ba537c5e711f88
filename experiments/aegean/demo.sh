#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The main job on a real map: a ship's route through the Aegean islands.
# Usage: experiments/aegean/demo.sh [SIGHTLINE [OUT_FOLDER]]   (called by `make demo`)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
sightline=${1:-build/release/bin/sightline}
out=${2:-out/aegean}
here=experiments/aegean
map=$here/aegean.geojson
mkdir -p "$out"

run() {
    echo "+ sightline $*"
    "$sightline" "$@"
}

run info "$map" --world -o "$out/info.json"
run graph "$map" --world -o "$out/graph.json" --vtk "$out/graph.vtp" --svg "$out/graph.svg"
run graph "$map" --world --tangent -o "$out/tangent.json"

# Without VTK there are no PNG pictures; anything else that goes wrong ends the demo.
pictures=yes
if ! complaint=$("$sightline" render "$map" --world --png "$out/map.png" 2>&1); then
    echo "$complaint"
    [[ $complaint == *"without VTK"* ]] || exit 1
    pictures=no
fi

# One line a route: file name, from, to, title; numbers as they stand in ports.json.
python3 "$here/summary.py" --routes "$here/ports.json" > "$out/routes.txt"
while read -r name from to title; do
    run path "$map" --world "--from=$from" "--to=$to" -o "$out/$name.json" \
        --vtk "$out/$name.vtp" --svg "$out/$name.svg"
    if [[ $pictures == yes ]]; then
        run render "$map" --world "$out/tangent.json" "$out/$name.json" \
            --title "The shortest way from $title, in km, and the tangent graph" --png "$out/$name.png"
    fi
done < "$out/routes.txt"

python3 "$here/summary.py" "$out"
