#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make aegean.geojson, the Aegean Sea as one polygon with its islands as holes, and ports.json.

    python3 make_aegean.py            # needs python3 and npm, and the network once

Source: Natural Earth 1:10m land (public domain), in the TopoJSON of the npm package `world-atlas`.
No package but Python's own library is used. All geometry after the projection is exact, on integer
metres, so the same package gives the same bytes. README.md says what each step is for.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tarfile
import tempfile

PACKAGE = "world-atlas"
VERSION = "2.0.2"
MEMBER = "package/land-10m.json"

# The map: kilometres east and north of the centre, azimuthal equidistant on the mean sphere.
CENTRE = (25.5, 37.75)  # longitude, latitude in degrees
EARTH_RADIUS_M = 6371008.8
BOX = (-260_000, -340_000, 260_000, 375_000)  # metres: x0, y0, x1, y1

# At sea just off each harbour (the coast at 1:10m knows no quays): longitude, latitude.
PORTS = {
    "Piraeus": (23.62, 37.93),
    "Rhodes": (28.24, 36.447),
    "Thessaloniki": (22.93, 40.62),
    "Heraklion": (25.135, 35.35),
}
ROUTES = [["Piraeus", "Rhodes"], ["Thessaloniki", "Heraklion"]]


# --- source ---------------------------------------------------------------------------------------


def fetch(folder):
    """The TopoJSON of the pinned package, fetched by npm into `folder`."""
    subprocess.run(["npm", "pack", "--silent", f"{PACKAGE}@{VERSION}"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    (archive,) = pathlib.Path(folder).glob(f"{PACKAGE}-*.tgz")
    with tarfile.open(archive) as tar:
        manifest = json.load(tar.extractfile("package/package.json"))
        if manifest["version"] != VERSION:
            sys.exit(f"npm delivered {PACKAGE} {manifest['version']}, wanted {VERSION}")
        return json.load(tar.extractfile(MEMBER))


def outer_rings(topology):
    """Outer ring of every land polygon in degrees, without the repeated closing vertex."""
    (sx, sy), (tx, ty) = topology["transform"]["scale"], topology["transform"]["translate"]
    arcs = []
    for arc in topology["arcs"]:
        x = y = 0
        points = []
        for dx, dy in arc:
            x, y = x + dx, y + dy
            points.append((x * sx + tx, y * sy + ty))
        arcs.append(points)
    (land,) = topology["objects"]["land"]["geometries"]
    for polygon in land["arcs"]:  # polygon[1:] are lakes: no part of the sea
        ring = []
        for index in polygon[0]:
            arc = arcs[index] if index >= 0 else arcs[~index][::-1]
            ring.extend(arc[1:] if ring else arc)
        if ring[0] != ring[-1]:
            sys.exit("a ring of the source does not close")
        yield ring[:-1]


def project(point):
    """Azimuthal equidistant about CENTRE, rounded to whole metres."""
    longitude, latitude = (math.radians(v) for v in point)
    longitude0, latitude0 = (math.radians(v) for v in CENTRE)
    d = longitude - longitude0
    x = math.cos(latitude) * math.sin(d)
    y = (math.cos(latitude0) * math.sin(latitude)
         - math.sin(latitude0) * math.cos(latitude) * math.cos(d))
    z = (math.sin(latitude0) * math.sin(latitude)
         + math.cos(latitude0) * math.cos(latitude) * math.cos(d))
    distance = math.hypot(x, y)
    stretch = math.atan2(distance, z) / distance if distance > 0 else 1
    return round(EARTH_RADIUS_M * stretch * x), round(EARTH_RADIUS_M * stretch * y)


# --- exact geometry on integer points -------------------------------------------------------------


def orientation(a, b, c):
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (value > 0) - (value < 0)


def on_segment(a, b, p):
    return (orientation(a, b, p) == 0 and min(a[0], b[0]) <= p[0] <= max(a[0], b[0])
            and min(a[1], b[1]) <= p[1] <= max(a[1], b[1]))


def meet(a, b, c, d):
    """Whether the closed segments ab and cd share a point."""
    return ((orientation(a, b, c) * orientation(a, b, d) < 0
             and orientation(c, d, a) * orientation(c, d, b) < 0)
            or on_segment(a, b, c) or on_segment(a, b, d)
            or on_segment(c, d, a) or on_segment(c, d, b))


def doubled_area(ring):
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1]))


def contains(ring, p):
    """Whether p lies inside the ring or on it."""
    inside = False
    for a, b in zip(ring, ring[1:] + ring[:1]):
        if on_segment(a, b, p):
            return True
        if (a[1] > p[1]) != (b[1] > p[1]):
            upward = b[1] > a[1]
            if (orientation(a, b, p) > 0) == upward:
                inside = not inside
    return inside


def meeting_edges(edges, cell=4000):
    """All pairs i < j of edges (a, b) that share a point, ascending."""
    grid = {}
    for i, (a, b) in enumerate(edges):
        for x in range(min(a[0], b[0]) // cell, max(a[0], b[0]) // cell + 1):
            for y in range(min(a[1], b[1]) // cell, max(a[1], b[1]) // cell + 1):
                grid.setdefault((x, y), []).append(i)
    pairs = {(i, j) for bucket in grid.values() for k, j in enumerate(bucket) for i in bucket[:k]}
    return sorted((i, j) for i, j in pairs if meet(*edges[i], *edges[j]))


# --- repair ---------------------------------------------------------------------------------------


def without_repeats_and_spikes(ring):
    """Drops a vertex equal to the one before it, and the tip of a spike a b a."""
    ring = list(ring)
    i = 0
    while len(ring) > 2 and i < len(ring):
        before, here, after = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
        forward = ((after[0] - here[0]) * (here[0] - before[0])
                   + (after[1] - here[1]) * (here[1] - before[1]))
        if here == before or (orientation(before, here, after) == 0 and forward < 0):
            del ring[i]
            i = max(i - 2, 0)
        else:
            i += 1
    return ring


def simple(ring, log):
    """The ring with its smaller loop cut off wherever it meets itself."""
    ring = without_repeats_and_spikes(ring)
    while len(ring) > 2:
        n = len(ring)
        edges = [(ring[i], ring[(i + 1) % n]) for i in range(n)]
        bad = [(i, j) for i, j in meeting_edges(edges) if j - i not in (1, n - 1)]
        if not bad:
            return ring
        i, j = bad[0]
        inner, outer = ring[i + 1:j + 1], ring[j + 1:] + ring[:i + 1]
        loop, ring = sorted((inner, outer), key=lambda r: abs(doubled_area(r)))
        log.append(f"loop of {len(loop)} vertices at {edges[i][0]} m cut off")
        ring = without_repeats_and_spikes(ring)
    return []


# --- clipping to the box --------------------------------------------------------------------------


def strictly_inside(p):
    return BOX[0] < p[0] < BOX[2] and BOX[1] < p[1] < BOX[3]


def clipped(a, b):
    """The part of segment ab in the box as two points on whole metres, or None."""
    low, high = (0, 1), (1, 1)  # parameters as fractions (numerator, denominator > 0)
    for axis in (0, 1):
        d = b[axis] - a[axis]
        for side, sign in ((BOX[axis], 1), (BOX[axis + 2], -1)):
            slope, start = sign * d, sign * (a[axis] - side)  # inside: start + t * slope >= 0
            if slope == 0:
                if start <= 0:
                    return None
            elif slope > 0 and -start * low[1] > low[0] * slope:
                low = (-start, slope)
            elif slope < 0 and start * high[1] < high[0] * -slope:
                high = (start, -slope)
    if low[0] * high[1] >= high[0] * low[1]:
        return None

    def at(t):
        # Nearest whole metre; exact on the side that it lies on, because that is whole.
        return tuple((2 * (a[k] * t[1] + (b[k] - a[k]) * t[0]) + t[1]) // (2 * t[1]) for k in (0, 1))

    return at(low), at(high)


def coast_chains(ring):
    """The parts of a ring inside the box: ([whole ring], []) or ([], chains from side to side)."""
    if all(strictly_inside(p) for p in ring):
        return [ring], []
    n = len(ring)
    pieces = [clipped(ring[i], ring[(i + 1) % n]) for i in range(n)]
    first = next((i for i in range(n) if not strictly_inside(ring[i])), 0)
    chains, chain = [], []
    for i in (k % n for k in range(first, first + n)):
        if pieces[i] is None:
            continue
        if not chain:
            chain = [pieces[i][0]]
        chain.append(pieces[i][1])
        if not strictly_inside(pieces[i][1]):
            chains.append(chain)
            chain = []
    if chain:
        sys.exit("a coast ends inside the box")
    return [], chains


def round_the_box(p):
    """Position of a point of the box's boundary, counter-clockwise from the lower left corner."""
    x0, y0, x1, y1 = BOX
    width, height = x1 - x0, y1 - y0
    if p[1] == y0:
        return p[0] - x0
    if p[0] == x1:
        return width + p[1] - y0
    if p[1] == y1:
        return width + height + x1 - p[0]
    if p[0] == x0:
        return 2 * width + height + y1 - p[1]
    return sys.exit(f"{p} is not on the box")


def sea_components(chains):
    """Outer rings of the sea, from coast chains with the sea on their left. (Weiler-Atherton)"""
    x0, y0, x1, y1 = BOX
    perimeter = 2 * (x1 - x0 + y1 - y0)
    corners = [(round_the_box(c), c) for c in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    starts = {round_the_box(chain[0]): k for k, chain in enumerate(chains)}
    if len(starts) != len(chains):
        sys.exit("two coasts meet the box in one place")
    rings, unused = [], set(range(len(chains)))
    while unused:
        k = min(unused)
        ring = []
        while k in unused:
            unused.remove(k)
            ring += chains[k]
            here = round_the_box(chains[k][-1])
            ahead = {(s - here) % perimeter: c for s, c in starts.items()}
            step = min(ahead)
            ring += [c for d, c in sorted(((s - here) % perimeter, c) for s, c in corners)
                     if 0 < d < step]
            k = ahead[step]
        rings.append(ring)
    return rings or [[c for _, c in corners]]


# --- the map --------------------------------------------------------------------------------------


def free_water(land):
    """(outer ring, islands, log): the largest piece of sea in the box and the islands in it."""
    log, islands, chains = [], [], []
    for ring in land:
        ring = [project(p) for p in ring]
        if (max(p[0] for p in ring) <= BOX[0] or min(p[0] for p in ring) >= BOX[2]
                or max(p[1] for p in ring) <= BOX[1] or min(p[1] for p in ring) >= BOX[3]):
            continue
        if doubled_area(ring) > 0:
            ring = ring[::-1]  # the sea on the left
        whole, cut = coast_chains(ring)
        islands += whole
        chains += cut
    seas = [s for s in (simple(s, log) for s in sea_components(chains)) if s]
    seas.sort(key=lambda s: (-doubled_area(s), s))
    for sea in seas[1:]:
        log.append(f"separate sea of {doubled_area(sea) / 2e6:.1f} km2 at {sea[0]} m left out")
    kept = []
    for island in (simple(i, log) for i in islands):
        if island and contains(seas[0], island[0]):
            kept.append(island)
    return seas[0], sorted(kept, key=lambda i: (-abs(doubled_area(i)), i)), log


def check(rings):
    """Every ring simple and apart from every other: edges meet only where one follows the other."""
    edges, follows = [], []
    for ring in rings:
        first, n = len(edges), len(ring)
        edges += [(ring[i], ring[(i + 1) % n]) for i in range(n)]
        follows += [first + (i + 1) % n for i in range(n)]
    for i, j in meeting_edges(edges):
        if follows[i] != j and follows[j] != i:
            sys.exit(f"edges {edges[i]} and {edges[j]} meet")


def written(outer, islands):
    """The GeoJSON text: one ring a line, kilometres with three decimals."""
    def line(ring):
        return "[" + ",".join(f"[{x / 1000:g},{y / 1000:g}]" for x, y in ring + ring[:1]) + "]"

    about = {
        "source": f"Natural Earth 1:10m land, from the npm package {PACKAGE} {VERSION} (land-10m.json)",
        "licence": "public domain (Natural Earth)",
        "made_by": "experiments/aegean/make_aegean.py",
        "units": f"kilometres east and north of {CENTRE[0]} E {CENTRE[1]} N, "
                 f"azimuthal equidistant, sphere of {EARTH_RADIUS_M} m",
        "meaning": "the outer ring is the free water, each hole an island: read with --world",
        "world": True,
    }
    head = json.dumps(about, indent=1)[:-2]
    rings = ",\n".join(line(r) for r in [outer] + islands)
    return (head + ',\n "type": "FeatureCollection",\n "features": [{"type": "Feature", '
            '"properties": {"name": "Aegean Sea"}, "geometry": {"type": "Polygon", "coordinates": [\n'
            + rings + "\n]}}]}\n")


def ports(outer, islands):
    """The text of ports.json; every port has to lie in the water."""
    lines = []
    for name, degrees in PORTS.items():
        x, y = project(degrees)
        if not contains(outer, (x, y)) or any(contains(i, (x, y)) for i in islands):
            sys.exit(f"{name} is not at sea")
        lines.append(f' "{name}": {{"longitude": {degrees[0]}, "latitude": {degrees[1]}, '
                     f'"at": [{x / 1000:g}, {y / 1000:g}]}}')
    return ('{"ports": {\n' + ",\n".join(lines) + '\n},\n"routes": ' + json.dumps(ROUTES) + "}\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--input", help="land-10m.json already at hand, instead of npm")
    parser.add_argument("-o", "--output", type=pathlib.Path,
                        default=pathlib.Path(__file__).with_name("aegean.geojson"))
    args = parser.parse_args()
    if args.input:
        topology = json.loads(pathlib.Path(args.input).read_text())
    else:
        with tempfile.TemporaryDirectory() as folder:
            topology = fetch(folder)
    outer, islands, log = free_water(outer_rings(topology))
    outer = outer if doubled_area(outer) > 0 else outer[::-1]
    islands = [i if doubled_area(i) < 0 else i[::-1] for i in islands]
    check([outer] + islands)
    args.output.write_text(written(outer, islands))
    args.output.with_name("ports.json").write_text(ports(outer, islands))
    for line in log:
        print(line)
    print(f"{args.output}: {len(outer) + sum(map(len, islands))} vertices, {len(islands)} islands, "
          f"{args.output.stat().st_size} bytes")


if __name__ == "__main__":
    main()
