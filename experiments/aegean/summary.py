#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The summary table of demo.sh, from the JSON files that the program wrote."""

import json
import pathlib
import sys

TIERS = ("calls", "filter", "interval", "exact", "undecided")


def routes(ports_file):
    """Yields (file stem, from, to, title) of every route, coordinates as `x,y`."""
    text = json.loads(pathlib.Path(ports_file).read_text(), parse_float=str, parse_int=str)
    for start, end in text["routes"]:
        places = (",".join(text["ports"][port]["at"]) for port in (start, end))
        yield f"{start}-{end}".lower(), *places, f"{start} to {end}"


def seconds(document):
    return document["stats"]["seconds"]["build"]


def rows(folder):
    """Yields (what, value) lines for the structures found in the folder."""
    graph, tangent = (json.loads((folder / f"{n}.json").read_text()) for n in ("graph", "tangent"))
    yield "vertices", f"{graph['scene']['vertices']:,}"
    yield "islands", f"{graph['scene']['bodies']:,}"
    for name, document in (("visibility graph", graph), ("tangent graph", tangent)):
        yield name, f"{len(document['result']['edges']):,} edges in {seconds(document):.3f} s"
    for line in (folder / "routes.txt").read_text().splitlines():
        name = line.split()[0]
        document = json.loads((folder / f"{name}.json").read_text())
        result = document["result"]
        yield (name, f"{result['length']['approx_value']:.3f} km, "
                     f"{len(result['points']) - 2} turns, {seconds(document):.3f} s")


def tier_table(document):
    yield "predicate", *TIERS
    for name, counts in document["stats"]["predicates"].items():
        if counts["calls"]:
            yield name, *(f"{counts[tier]:,}" for tier in TIERS)


def main():
    if sys.argv[1] == "--routes":
        for route in routes(sys.argv[2]):
            print(*route)
        return
    folder = pathlib.Path(sys.argv[1])
    print()
    for what, value in rows(folder):
        print(f"{what:<24}{value}")
    for name in ("graph", "tangent"):
        print(f"\nwhich arithmetic decided ({name}):")
        for first, *rest in tier_table(json.loads((folder / f"{name}.json").read_text())):
            print(f"  {first:<22}" + "".join(f"{value:>14}" for value in rest))
    print(f"\nfiles in {folder}: " + " ".join(sorted(p.name for p in folder.iterdir())))


if __name__ == "__main__":
    main()
