# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes from lists and arrays, what they consist of, and what is wrong with bad ones."""

import pickle
import struct

import numpy as np
import pytest
import sightline

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
INNER = [(1, 1), (3, 1), (3, 3), (1, 3)]


def test_vertices_are_numbered_in_order_of_polygons_walls_points():
    scene = sightline.Scene2([SQUARE], walls=[[(6, 0), (7, 1), (8, 0)]], points=[(9, 9)])
    expected = SQUARE + [(6, 0), (7, 1), (8, 0), (9, 9)]
    assert scene.vertices.tolist() == [list(map(float, p)) for p in expected]
    assert scene.walls.tolist() == [[4, 5], [5, 6]]
    assert scene.points.tolist() == [7]
    assert (scene.vertex_count, scene.edge_count, scene.body_count) == (8, 6, 1)
    assert not scene.has_world


def test_lists_arrays_and_closed_rings_are_the_same_scene():
    from_list = sightline.Scene2([SQUARE])
    assert sightline.Scene2([np.array(SQUARE)]) == from_list
    assert sightline.Scene2([np.array(SQUARE, dtype=np.float32)[:, :]]) == from_list
    assert sightline.Scene2(np.array([SQUARE])) == from_list
    assert sightline.Scene2([SQUARE + SQUARE[:1]]) == from_list
    assert sightline.Scene2([sightline.Polygon2(SQUARE)]) == from_list
    assert sightline.Scene2([INNER]) != from_list


def test_edges_have_the_body_on_their_left_whatever_the_orientation_was():
    for ring in (SQUARE, SQUARE[::-1]):
        scene = sightline.Scene2([ring])
        ends = scene.vertices[scene.edges]
        area = np.sum(np.cross(ends[:, 0], ends[:, 1])) / 2
        assert area == 16


def test_a_hole_is_a_ring_of_its_body():
    scene = sightline.Scene2([sightline.Polygon2(SQUARE, [INNER])])
    assert [(r.body, r.is_hole) for r in scene.rings] == [(0, False), (0, True)]
    assert sorted(scene.rings[1].vertices) == [4, 5, 6, 7]


def test_the_holes_of_a_world_are_bodies():
    scene = sightline.Scene2([sightline.Polygon2(SQUARE, [INNER])], world=True)
    assert scene.has_world
    assert scene.body_count == 1
    assert [r.body for r in scene.rings] == [None, 0]


def test_vertices_are_a_view_that_outlives_its_scene_and_cannot_be_written():
    vertices = sightline.Scene2([SQUARE]).vertices
    assert not vertices.flags.owndata
    assert vertices.tolist() == [list(map(float, p)) for p in SQUARE]
    with pytest.raises(ValueError):
        vertices[0, 0] = 1


def test_points_are_added_behind():
    scene = sightline.Scene2([SQUARE]).with_points([(5, 5), (6, 6)])
    assert scene.points.tolist() == [4, 5]
    assert scene.vertices[4:].tolist() == [[5, 5], [6, 6]]


@pytest.fixture
def mixed():
    room = sightline.Polygon2([(-1, -1), (9, -1), (9, 9), (-1, 9)], [SQUARE])
    hollow = sightline.Polygon2([(5, 0), (8, 0), (8, 4), (5, 4)], [[(6, 1), (7, 1), (6, 3)]])
    return sightline.Scene2([room, hollow], walls=[[(0, 6), (0.1, 7), (1 / 3, 6)]], points=[(5, 5)], world=True)


def test_text_and_back_is_the_same_scene(mixed):
    assert sightline.Scene2.from_text(mixed.to_text()) == mixed
    assert sightline.Scene2.from_geojson(mixed.to_geojson(), world=True) == mixed
    assert sightline.Scene2.from_wkt(mixed.to_wkt(), world=True) == mixed
    assert sightline.Scene2.from_wkt(mixed.to_wkt().splitlines()[1]).body_count == 1


def test_a_scene_can_be_pickled(mixed):
    assert pickle.loads(pickle.dumps(mixed)) == mixed
    assert pickle.loads(pickle.dumps(sightline.Scene2([SQUARE]))) == sightline.Scene2([SQUARE])


def test_well_known_text():
    scene = sightline.Scene2.from_wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0)) LINESTRING (6 0, 7 1)")
    assert scene == sightline.Scene2([SQUARE], walls=[[(6, 0), (7, 1)]])


def test_files_are_read_by_their_name(mixed, tmp_path):
    for name, text in (("a.wkt", mixed.to_wkt()), ("a.geojson", mixed.to_geojson()),
                       ("a.txt", mixed.to_text())):
        path = tmp_path / name
        path.write_text(text)
        assert sightline.Scene2.read(path, world=True) == mixed
        assert sightline.Scene2.read(str(path), world=True) == mixed


@pytest.mark.parametrize("text", ["POLYGON ((0 0, 1 0", "POLYGON ((0 0, 1 0, x 1))", "CIRCLE (1 2)"])
def test_a_syntax_error_names_the_place(text, tmp_path):
    path = tmp_path / "bad.wkt"
    path.write_text(text)
    with pytest.raises(sightline.SightlineError, match="bad.wkt:1"):
        sightline.Scene2.read(path)
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.Scene2.from_wkt(text)
    assert caught.value.code == "syntax"


def test_a_file_that_is_not_there():
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.Scene2.read("/nowhere/at/all.wkt")
    assert caught.value.code == "cannot_open"


BAD = {
    "self_intersection": [[(0, 0), (2, 2), (2, 0), (0, 2)]],
    "too_few_vertices": [[(0, 0), (1, 1)]],
    "repeated_vertex": [[(0, 0), (1, 0), (1, 0), (0, 1)]],
    "not_finite": [[(0, 0), (1, 0), (float("nan"), 1)]],
    "body_overlap": [SQUARE, [(2, 2), (6, 2), (6, 6)]],
    "hole_outside": [sightline.Polygon2(INNER, [[(5, 5), (6, 5), (6, 6)]])],
}


@pytest.mark.parametrize("code", BAD)
def test_bad_data_raises_with_its_code_and_one_line(code):
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.Scene2(BAD[code])
    assert caught.value.code == code
    assert str(caught.value) and "\n" not in str(caught.value)


def test_a_point_in_a_body_raises():
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.Scene2([SQUARE]).with_points([(2, 2)])
    assert caught.value.code == "inside_body"


@pytest.mark.parametrize(
    "polygons, error",
    [
        ([[1, 2, 3]], ValueError),
        ([[(1, 2, 3), (4, 5, 6), (7, 8, 9)]], ValueError),
        ([[(0, 0), (1,), (0, 1)]], TypeError),
        ([["a", "b"]], TypeError),
        (5, TypeError),
    ],
    ids=repr,
)
def test_what_is_no_ring_raises(polygons, error):
    with pytest.raises(error):
        sightline.Scene2(polygons)


def test_repair_merges_and_says_so():
    with pytest.warns(sightline.RepairWarning) as said:
        scene = sightline.Scene2([SQUARE, [(2, 2), (6, 2), (6, 6), (2, 6)]], repair=True)
    assert scene.body_count == 1 and len(said) >= 1
    assert sorted(map(tuple, scene.vertices.tolist())) == sorted(
        [(0, 0), (4, 0), (4, 2), (6, 2), (6, 6), (2, 6), (2, 4), (0, 4)])
    with pytest.warns(sightline.RepairWarning):
        text = "POLYGON ((0 0, 4 0, 4 0, 4 4, 0 4, 0 0))"
        assert sightline.Scene2.from_wkt(text, repair=True) == sightline.Scene2([SQUARE])


def test_repair_of_a_valid_scene_says_nothing(recwarn):
    assert sightline.Scene2([SQUARE], repair=True) == sightline.Scene2([SQUARE])
    assert not recwarn.list


def test_info_counts_and_lists_what_is_degenerate(mixed):
    neat = sightline.info(sightline.Scene2([SQUARE]))
    assert (neat["vertices"], neat["bodies"], neat["body_edges"]) == (4, 1, 4)
    assert (neat["low"], neat["high"]) == ((0, 0), (4, 4))
    assert not neat["is_degenerate"]
    assert sightline.info(mixed)["has_world"] and sightline.info(mixed)["walls"] == 2
    touching = sightline.info(sightline.Scene2([SQUARE, [(4, 4), (6, 4), (6, 6)], [(4, 1), (5, 1), (5, 2), (4, 2)]]))
    assert touching["is_degenerate"]
    assert touching["coincident"] == [[2, 4]]
    assert {tuple(c["bodies"]): (c["points"], c["edges"]) for c in touching["contacts"]} == {
        (0, 1): (1, 0), (0, 2): (0, 1)}


def wad(name, vertices, lines):
    """The bytes of a WAD with one map of one-sided lines."""
    lumps = [
        (name, b""),
        ("VERTEXES", b"".join(struct.pack("<hh", *v) for v in vertices)),
        ("LINEDEFS", b"".join(struct.pack("<HHHHHHH", a, b, 1, 0, 0, 0, 0xFFFF) for a, b in lines)),
    ]
    body, directory = b"", b""
    for lump, data in lumps:
        directory += struct.pack("<ii8s", 12 + len(body), len(data), lump.encode())
        body += data
    return struct.pack("<4sii", b"PWAD", len(lumps), 12 + len(body)) + body + directory


def test_the_lines_of_a_doom_map_are_walls(tmp_path):
    path = tmp_path / "a.wad"
    path.write_bytes(wad("MAP01", [(0, 0), (8, 0), (8, 8)], [(0, 1), (1, 2)]))
    scene = sightline.Scene2.read_doom(path, "map01")
    ends = {tuple(sorted(map(tuple, wall))) for wall in scene.vertices[scene.walls].tolist()}
    assert ends == {((0, 0), (8, 0)), ((8, 0), (8, 8))}
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.Scene2.read_doom(path, "MAP02")
    assert caught.value.code == "bad_parameter"


def test_errors_can_be_pickled():
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.Scene2(BAD["too_few_vertices"])
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (copy.code, str(copy)) == (caught.value.code, str(caught.value))
