# SPDX-License-Identifier: GPL-3.0-or-later
"""Visibility polygons: exact rings worked out by hand, and what they have to satisfy."""

from fractions import Fraction

import numpy as np
import oracle
import pytest
import sightline

ROOM = [(0, 0), (8, 0), (8, 8), (0, 8)]
PILLAR = [(3, 3), (5, 3), (5, 5), (3, 5)]


@pytest.fixture(scope="module")
def room():
    return sightline.Scene2([sightline.Polygon2(ROOM, [PILLAR])], world=True)


def test_the_shadow_of_a_pillar_is_exact(room):
    seen = sightline.visibility_polygon(room, (1, 4))
    assert seen.ring == [
        (0, 0), (8, 0), (8, Fraction(1, 2)), (3, 3), (3, 5), (8, Fraction(15, 2)), (8, 8), (0, 8)]
    assert oracle.area(seen.ring) == Fraction(83, 2)
    assert len(seen) == 8 and seen.is_bounded


def test_a_viewpoint_of_thirds_gives_coordinates_no_double_has(room):
    seen = sightline.visibility_polygon(room, ("1/3", 4))
    # From (1/3, 4) past (3, 3): slope -3/8, so it meets x = 8 at 4 - 23/3 * 3/8.
    assert (8, Fraction(9, 8)) in seen.ring
    assert (8, Fraction(55, 8)) in seen.ring
    seen = sightline.visibility_polygon(room, (1, "1/3"))
    # Past (5, 3): slope 2/3; it meets x = 8 at 1/3 + 7 * 2/3.
    assert (8, 5) in seen.ring
    # Past (3, 5): slope 7/3; it meets y = 8 at 1 + 23/3 * 3/7.
    assert (Fraction(30, 7), 8) in seen.ring


def test_the_approximate_ring_is_the_nearest_doubles(room):
    seen = sightline.visibility_polygon(room, (1, "1/3"))
    assert seen.approx_ring.tolist() == [[float(x), float(y)] for x, y in seen.ring]
    assert not seen.at_infinity.any()


def test_without_a_world_sight_ends_at_infinity():
    scene = sightline.Scene2([PILLAR])
    seen = sightline.visibility_polygon(scene, (1, 4))
    assert not seen.is_bounded
    infinite = [p for p in seen.ring if isinstance(p, sightline.Direction)]
    assert np.count_nonzero(seen.at_infinity) == len(infinite)
    assert any(d.x > 0 and d.x == -2 * d.y for d in infinite), "the direction past (3, 3)"
    assert any(d.x > 0 and d.x == 2 * d.y for d in infinite), "the direction past (3, 5)"
    assert [p for p in seen.ring if not isinstance(p, sightline.Direction)] == [(3, 3), (3, 5)]


def test_a_prepared_scene_answers_as_the_one_off_function():
    scene = sightline.families.generate("dense", 300, seed=4)
    prepared = sightline.PointVisibility2(scene)
    low, high = scene.vertices.min(axis=0), scene.vertices.max(axis=0)
    answered = 0
    for x, y in np.random.default_rng(1).uniform(low, high, size=(40, 2)):
        try:
            seen = prepared.from_point((x, y))
        except sightline.SightlineError as error:
            assert error.code == "inside_body"
            continue
        assert seen == sightline.visibility_polygon(scene, (x, y))
        assert seen == prepared.from_point((x, y), arithmetic="exact")
        assert oracle.area(seen.ring) > 0
        answered += 1
    assert answered > 20


def test_a_prepared_scene_keeps_its_scene_alive():
    prepared = sightline.PointVisibility2(sightline.Scene2([ROOM], world=True))
    assert oracle.area(prepared.from_point((1, 1)).ring) == 64
    assert prepared.scene.vertex_count == 4


def test_a_corner_sees_what_its_free_directions_see(room):
    seen = sightline.visibility_polygon(room, (3, 3))
    assert (3, 8) in seen.ring and (8, 3) in seen.ring
    assert oracle.area(seen.ring) == 64 - 25


def test_sight_through_a_pinhole_is_a_needle():
    touching = [[(2, 0), (6, 0), (4, 2)], [(4, 2), (6, 4), (2, 4)]]
    scene = sightline.Scene2(touching)
    assert sightline.visibility_polygon(scene, (0, 2)).needles == []
    ((near, far),) = sightline.visibility_polygon(scene, (0, 2), needles=True).needles
    assert near == (4, 2)
    assert isinstance(far, sightline.Direction) and far.x > 0 and far.y == 0


@pytest.mark.parametrize("point, code", [((4, 4), "inside_body"), ((9, 4), "outside_of_world")])
def test_a_point_in_the_solid_sees_nothing(room, point, code):
    for ask in (lambda: sightline.visibility_polygon(room, point),
                lambda: sightline.PointVisibility2(room).from_point(point)):
        with pytest.raises(sightline.SightlineError) as caught:
            ask()
        assert caught.value.code == code
