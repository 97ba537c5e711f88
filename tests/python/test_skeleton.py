# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of space and their visibility skeletons."""

from fractions import Fraction

import numpy as np
import pytest
import sightline
from sightline import families

CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
CUBE = (CORNERS, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def moved(mesh, by):
    return np.array(mesh[0]) + by, mesh[1]


def test_cube():
    scene = sightline.Scene3([CUBE])
    assert scene.vertices.shape == (8, 3) and scene.edges.shape == (12, 2)
    assert (scene.face_count, scene.body_count, len(scene.triangles)) == (6, 1, 12)
    skeleton = sightline.skeleton(scene)
    assert (skeleton.node_count, skeleton.arc_count) == (24, 48)
    assert {node.type for node in skeleton.nodes} == {"VV"}
    assert {arc.type for arc in skeleton.arcs} == {"Fv"}
    for arc in skeleton.arcs:
        for n in arc.nodes:
            assert set(arc.vertices) <= set(skeleton.nodes[n].vertices)


def test_lines_are_exact():
    scene = sightline.Scene3([CUBE, moved(CUBE, (3, 0.5, 0.25))])
    skeleton = sightline.skeleton(scene)
    for n, node in enumerate(skeleton.nodes):
        line = skeleton.plucker(n)
        if not all(isinstance(x, Fraction) for x in line):
            continue
        d, m = line[:3], line[3:]
        assert next(x for x in line if x != 0) == 1
        assert sum(x * y for x, y in zip(d, m)) == 0
        for v in node.vertices:
            p = [Fraction(float(x)) for x in scene.vertices[v]]
            assert m == (p[1] * d[2] - p[2] * d[1], p[2] * d[0] - p[0] * d[2], p[0] * d[1] - p[1] * d[0])


def test_segments_for_drawing():
    scene = families.generate3("tetrahedra", 3)
    skeleton = sightline.skeleton(scene)
    for a, arc in enumerate(skeleton.arcs):
        ends, at_infinity, through = skeleton.approx_segments(a, 3)
        assert ends.shape == (5, 2, 3) and at_infinity.shape == (5, 2) and through.shape == (5, 3)
        for (p, q), (p_far, q_far), x in zip(ends, at_infinity, through):
            if not p_far:
                assert np.array_equal(x, p)
            elif not q_far:
                assert np.array_equal(x, q)
            else:
                assert np.allclose(p, -q) and abs(x @ p) <= 1e-6 * np.abs(x).max() * np.abs(p).max()
        first, infinite, _ = skeleton.approx_segment(arc.nodes[0])
        assert np.array_equal(first[0], ends[0]) and np.array_equal(infinite[0], at_infinity[0])
        assert [e is None for e in arc.ends] == at_infinity[2].tolist()


def test_parts_threads_and_arithmetic():
    scene = families.generate3("polytopes", 3, 12)
    skeleton = sightline.skeleton(scene, threads=1)
    assert skeleton == sightline.skeleton(scene, threads=2)
    assert skeleton == sightline.skeleton(scene, arithmetic="exact")
    arc = next(a for a in skeleton.arcs if None not in a.ends)
    faces = arc.ends[0][0][0], arc.ends[1][0][0]
    part = sightline.skeleton(scene, pair=faces)
    assert 0 < part.arc_count < skeleton.arc_count
    assert all(faces[0] in [f for f, _ in a.ends[0] + a.ends[1]] for a in part.arcs)
    assert skeleton.tally["line_form3"]["calls"] > 0


def test_check():
    skeleton = sightline.skeleton(families.generate3("tetrahedra", 2))
    found = skeleton.check(100, seed=3)
    assert found["missing"] == found["false"] == 0 and found["crossings"] > 50
    assert found["mismatches"] == []


def test_files_and_errors(tmp_path):
    lines = ["OFF", "8 6 0"] + ["%g %g %g" % p for p in CORNERS]
    lines += [" ".join(map(str, (4, *face))) for face in CUBE[1]]
    (tmp_path / "cube.off").write_text("\n".join(lines) + "\n")
    assert sightline.skeleton(sightline.read_scene3(tmp_path / "cube.off")).node_count == 24
    (tmp_path / "open.off").write_text("\n".join(["OFF", "8 5 0"] + lines[2:-1]) + "\n")
    with pytest.raises(sightline.SightlineError) as error:
        sightline.read_scene3(tmp_path / "open.off")
    assert error.value.code == "open_surface"
    assert sightline.read_scene3(tmp_path / "open.off", sheets=True).face_count == 5
    with pytest.raises(sightline.SightlineError):
        families.generate3("no-such-family")
    with pytest.raises(ValueError):
        sightline.skeleton(sightline.Scene3([CUBE]), pair=(0, 99))
    with pytest.raises(IndexError):
        sightline.skeleton(sightline.Scene3([CUBE])).plucker(24)
