# SPDX-License-Identifier: GPL-3.0-or-later
"""The definitions, transcribed for scenes of disjoint convex polygons, with Fractions. Slow and obvious."""

from decimal import Decimal, localcontext
from fractions import Fraction
from itertools import combinations


def exact(point):
    return tuple(Fraction(c) for c in point)


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def counter_clockwise(ring):
    area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1]))
    return ring if area > 0 else ring[::-1]


def enters(a, b, ring):
    """Whether the open segment ab meets the interior of a convex counter-clockwise ring."""
    low, high = Fraction(0), Fraction(1)
    for p, q in zip(ring, ring[1:] + ring[:1]):
        at_a, at_b = cross(p, q, a), cross(p, q, b)  # inside: > 0, linear along ab
        if at_a <= 0 and at_b <= 0:
            return False
        if at_a != at_b:
            t = at_a / (at_a - at_b)
            low, high = (max(low, t), high) if at_b > at_a else (low, min(high, t))
    return low < high


def between(a, b, p):
    """Whether p lies in the open segment ab."""
    return cross(a, b, p) == 0 and p not in (a, b) and all(
        min(s, t) <= c <= max(s, t) for s, t, c in zip(a, b, p))


def visibility_graph(rings, collinear="nearest"):
    """Edges [u, v] of a scene whose polygons are the rings, in order."""
    rings = [[exact(p) for p in ring] for ring in rings]
    vertices = [p for ring in rings for p in ring]
    bodies = [counter_clockwise(ring) for ring in rings]
    return [
        [u, v]
        for u, v in combinations(range(len(vertices)), 2)
        if vertices[u] != vertices[v]
        and not any(enters(vertices[u], vertices[v], body) for body in bodies)
        and not (collinear == "nearest" and any(between(vertices[u], vertices[v], p) for p in vertices))
    ]


def distance(a, b):
    """The length of ab to 50 digits."""
    with localcontext() as context:
        context.prec = 60
        square = sum((exact(a)[k] - exact(b)[k]) ** 2 for k in (0, 1))
        return (Decimal(square.numerator) / Decimal(square.denominator)).sqrt()


def shortest_length(rings, start, end):
    """The length of a shortest path past the rings, to about 50 digits (Floyd and Warshall)."""
    rings = [[exact(p) for p in ring] for ring in rings]
    places = [exact(start), exact(end)] + [p for ring in rings for p in ring]
    bodies = [counter_clockwise(ring) for ring in rings]
    n = len(places)
    length = [[Decimal("Infinity")] * n for _ in range(n)]
    for u in range(n):
        for v in range(n):
            if not any(enters(places[u], places[v], body) for body in bodies):
                length[u][v] = distance(places[u], places[v])
    for k in range(n):
        for u in range(n):
            for v in range(n):
                length[u][v] = min(length[u][v], length[u][k] + length[k][v])
    return length[0][1]


def area(ring):
    """Twice the area of a ring of exact points, halved: exact."""
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, ring[1:] + ring[:1])) / 2


def random_triangles(random, count, side=12):
    """Disjoint triangles on a small lattice, so that collinear and touching-line cases are common."""
    rings = []
    while len(rings) < count:
        ring = [(random.randrange(side), random.randrange(side)) for _ in range(3)]
        if cross(*ring) == 0:
            continue
        if any(not apart(ring, other) for other in rings):
            continue
        rings.append(ring)
    return rings


def apart(one, other):
    """Whether two triangles share no point: some edge line has them strictly on different sides."""
    for a, b in ((one, other), (other, one)):
        a = counter_clockwise(a)
        if any(all(cross(p, q, r) < 0 for r in b) for p, q in zip(a, a[1:] + a[:1])):
            return True
    return False
