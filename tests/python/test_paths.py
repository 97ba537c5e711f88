# SPDX-License-Identifier: GPL-3.0-or-later
"""Shortest paths: lengths that are certain, against the definition."""

import math
import random
from decimal import Decimal
from fractions import Fraction

import oracle
import pytest
import sightline

PILLAR = [(3, 3), (5, 3), (5, 5), (3, 5)]


def test_a_path_round_a_pillar_turns_at_its_corners():
    path = sightline.shortest_path(sightline.Scene2([PILLAR]), (1, 4), (7, "7/2"))
    assert path.points == [(1, 4), (3, 3), (5, 3), (7, Fraction(7, 2))]
    assert path.vertices.tolist() == [0, 1]
    low, high = path.length
    expected = oracle.distance((1, 4), (3, 3)) + 2 + oracle.distance((5, 3), (7, Fraction(7, 2)))
    assert Decimal(low) <= expected <= Decimal(high)
    assert high - low <= 1e-12
    assert low <= path.approx_length <= high
    assert path.approx_points.tolist() == [[1, 4], [3, 3], [5, 3], [7, 3.5]]


def test_a_free_segment_is_the_path():
    path = sightline.shortest_path(sightline.Scene2([PILLAR]), (0, 0), (3, 4))
    assert len(path.vertices) == 0
    assert path.length[0] <= 5 <= path.length[1]


def test_random_paths_have_the_length_of_the_definition():
    generator = random.Random(11)
    for _ in range(40):
        rings = oracle.random_triangles(generator, generator.randrange(1, 5))
        path = sightline.shortest_path(sightline.Scene2(rings), (-1, Fraction(1, 3)), (13, 12))
        expected = oracle.shortest_length(rings, (-1, Fraction(1, 3)), (13, 12))
        slack = Decimal("1e-40")
        assert Decimal(path.length[0]) - slack <= expected <= Decimal(path.length[1]) + slack, rings
        assert math.isclose(path.length[0], path.length[1], rel_tol=1e-12)


def test_arithmetic_and_threads_change_nothing():
    scene = sightline.families.generate("grid", 4, 4)
    low, high = scene.vertices.min(axis=0) - 1, scene.vertices.max(axis=0) + 2
    first = sightline.shortest_path(scene, low, high)
    for options in ({"arithmetic": "exact"}, {"threads": 2}):
        other = sightline.shortest_path(scene, low, high, **options)
        assert other.points == first.points and other.length == first.length


@pytest.mark.parametrize("end, code", [((4, 4), "inside_body"), ((9, 4), "outside_of_world"),
                                       ((2, 2), "unreachable")])
def test_there_is_no_path(end, code):
    cell = [[(1, 1), (3, 1), (3, 3), (1, 3), (1, 1)]]
    room = sightline.Polygon2([(0, 0), (8, 0), (8, 8), (0, 8)], [[(4, 3), (5, 3), (5, 5), (3.5, 5)]])
    scene = sightline.Scene2([room], walls=cell, world=True)
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.shortest_path(scene, (7, 1), end)
    assert caught.value.code == code
