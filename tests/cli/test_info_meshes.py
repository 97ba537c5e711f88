# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline info on scenes of space: formats, several files, sheets, worlds, repair, errors."""

import pytest
from program import load, run

CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(map(str, v)) for v in vertices]
    lines += [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


def cube(at=(0, 0, 0), size=1, turned=False):
    vertices = [tuple(a + size * c for a, c in zip(at, corner)) for corner in CORNERS]
    return off(vertices, [tuple(reversed(f)) if turned else f for f in FACES])


def obj(vertices, faces):
    return "".join(f"v {x} {y} {z}\n" for x, y, z in vertices) + "".join(
        "f " + " ".join(str(v + 1) for v in face) + "\n" for face in faces)


def ply(vertices, faces):
    return (f"ply\nformat ascii 1.0\nelement vertex {len(vertices)}\nproperty double x\nproperty double y\n"
            f"property double z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
            + "".join(f"{x} {y} {z}\n" for x, y, z in vertices)
            + "".join(" ".join(map(str, (len(f), *f))) + "\n" for f in faces))


def stl(vertices, faces):
    lines = ["solid cube"]
    for face in faces:
        for i in range(2, len(face)):
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex {} {} {}".format(*vertices[v]) for v in (face[0], face[i - 1], face[i])]
            lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid cube"]) + "\n"


@pytest.mark.parametrize("ending, text", [("off", off(CORNERS, FACES)), ("obj", obj(CORNERS, FACES)),
                                          ("ply", ply(CORNERS, FACES)), ("stl", stl(CORNERS, FACES))])
def test_a_cube_is_a_cube_in_each_format(folder, ending, text):
    (folder / f"cube.{ending}").write_text(text)
    finished = run("info", f"cube.{ending}", "-o", "info.json")
    assert finished.status == 0 and finished.err == ""
    document = load("info.json")
    assert document["kind"] == "info"
    assert document["scene"] == {"files": [f"cube.{ending}"], "vertices": 8, "bodies": 1}
    result = document["result"]
    assert (result["edges"], result["faces"], result["solids"], result["sheets"]) == (12, 6, 1, 0)
    assert result["box"] == [["0", "0", "0"], ["1", "1", "1"]]
    assert result["degenerate"] is False
    assert result["degeneracies"]["parallel_directions"] == 3


def test_files_are_bodies_that_may_touch(folder):
    (folder / "a.off").write_text(cube())
    (folder / "b.off").write_text(cube((1, 0, 0)))
    run("info", "a.off", "b.off", "-o", "info.json")
    result = load("info.json")["result"]
    assert result["solids"] == 2 and result["degenerate"] is True
    assert result["degeneracies"]["contacts"] == [{"bodies": [0, 1], "places": 4, "edges": 4, "faces": 1}]
    assert result["degeneracies"]["coincident_vertices"] == [[4, 8], [5, 9], [6, 10], [7, 11]]


def test_sheets_and_worlds(folder):
    (folder / "room.off").write_text(cube(size=9))
    (folder / "box.off").write_text(cube((4, 4, 0)))
    (folder / "wall.off").write_text(off([(1, 1, 1), (2, 1, 1), (2, 2, 1)], [(0, 1, 2)]))
    run("info", "room.off", "box.off", "--sheet", "wall.off", "--world", "-o", "info.json")
    document = load("info.json")
    assert document["options"] == {"world": True, "sheet": ["wall.off"]}
    assert document["scene"]["files"] == ["room.off", "box.off", "wall.off"]
    result = document["result"]
    assert (result["solids"], result["sheets"], result["world"], result["border_edges"]) == (1, 1, True, 3)
    run("info", "wall.off", "--sheets", "-o", "wall.json")
    assert load("wall.json")["result"]["sheets"] == 1


def test_repair(folder):
    (folder / "inwards.off").write_text(cube(turned=True))
    finished = run("info", "inwards.off")
    assert finished.status == 2 and "inwards.off:11: face 0" in finished.err and "looks inwards" in finished.err
    finished = run("info", "inwards.off", "--repair", "-o", "info.json")
    assert finished.status == 0 and "repair: inwards.off: " in finished.err
    result = load("info.json")["result"]
    assert result["repairs"] == ["inwards.off: solids and cavities turned because they looked the wrong way: 1"]


@pytest.mark.parametrize("texts, arguments, place, words", [
    ([off(CORNERS, FACES[:5])], [], "m0.off:11: face 0, edge [1, 3]", "read the file as sheets"),
    ([off([*CORNERS[:7], (1, 1, 2)], FACES)], [], "m0.off:16: face 5: is not planar", "triangulate"),
    ([off(CORNERS, [*FACES[:5], (1, 5, 7, 8)])], [], "m0.off:16:9: face 5 names vertex 8", "correct"),
    ([cube(), cube((0.5, 0.5, 0.5))], [], "m0.off:1", "overlap"),
    ([cube(size=3), cube((1, 1, 1))], [], "m1.off:11: face 0", "lies inside the solid with m0.off:11: face 0"),
    ([cube(), cube((4, 4, 4))], ["--world"], "m1.off:11: face 0", "outside of the world"),
    (["OFF\n3 1\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"], ["--sheets"], "m0.off:6: face 0", "has no area"),
    (["OFF\n3 x\n"], [], "m0.off:2:3", "expected a whole number"),
])
def test_bad_meshes_are_told_in_one_line(folder, texts, arguments, place, words):
    names = [f"m{i}.off" for i in range(len(texts))]
    for name, text in zip(names, texts):
        (folder / name).write_text(text)
    finished = run("info", *names, *arguments, "-o", "out.json")
    assert finished.status == 2 and finished.out == ""
    assert finished.err.startswith(f"sightline: {place}") and words in finished.err
    assert finished.err.count("\n") == 1
    assert not (folder / "out.json").exists()


def test_a_missing_mesh(folder):
    finished = run("info", "no.off")
    assert finished.status == 2 and "no.off: cannot be read" in finished.err
