# SPDX-License-Identifier: GPL-3.0-or-later
"""sightline transversals: lines through four segments, and tangents to four triangles."""

import itertools
from fractions import Fraction

import pytest

from program import load, run, without_stats

# Skew, and long enough to be met by both lines that meet their carriers.
SKEW = """# four segments
-90 0 0  90 0 0   0 -90 2  0 90 2
-89 -88 -90  91 92 90   # no line break needed
-28 1 -90  32 1 90
"""
REGULUS = "0 0 0 0 1 0  1 0 0 1 1 1  2 0 0 2 1 2  3 -1 -3 3 1 3"


class Root2:
    """a + b √c with rational a and b, for one c."""

    def __init__(self, json):
        if isinstance(json, str):
            self.a, self.b, self.c = Fraction(json), Fraction(0), None
        else:
            self.a, self.b, self.c = (Fraction(json[k]) for k in "abc")

    def approx(self):
        return float(self.a) + (float(self.b) * float(self.c) ** 0.5 if self.c else 0)


def side(line, p, q):
    """The side of a Plücker vector to the line through two points, as a double."""
    d = [b - a for a, b in zip(p, q)]
    m = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    return sum(x * y for x, y in zip(line, m + d))


def numbers(text):
    return [float(Fraction(w)) for line in text.splitlines() for w in line.split("#")[0].split()]


def test_document(folder):
    (folder / "skew.txt").write_text(SKEW)
    document = without_stats(run("transversals", "skew.txt").out)
    result = document.pop("result")
    assert document == {
        "sightline": {"version": "0.1.0", "format": 1},
        "kind": "transversals",
        "scene": {"files": ["skew.txt"], "segments": 4},
        "options": {"arithmetic": "filtered"},
    }
    assert result["components"] == []
    assert result["counts"] == {"segments": 4, "lines": len(result["lines"]), "components": 0}
    assert [entry["root"] for entry in result["lines"]] == [0, 1]
    x = numbers(SKEW)
    for entry in result["lines"]:
        assert entry["support"] == [0, 1, 2, 3]
        line = [Root2(n).approx() for n in entry["plucker"]]
        assert next(n for n in line if n) == 1
        for i in range(4):
            p, q = x[6 * i:6 * i + 3], x[6 * i + 3:6 * i + 6]
            assert abs(side(line, p, q)) < 1e-9


def test_a_family_is_a_component(folder):
    (folder / "regulus.txt").write_text(REGULUS)
    result = run("transversals", "regulus.txt").json["result"]
    assert result["lines"] == []
    assert result["counts"] == {"segments": 4, "lines": 0, "components": 1, "regulus": 1}
    (component,) = result["components"]
    assert component["support"] == [0, 1, 2, 3] and component["kind"] == "regulus"
    assert len(component["generators"]) == 3
    (piece,) = component["ranges"]
    assert piece["from"] == ["1", "0", "0", "0", "0", "0"]
    assert piece["to"] == ["1", "0", "1", "1", "0", "-1"]


def test_decimals_are_exact(folder):
    # One tenth is no double: with it rounded the four would not lie on one regulus.
    text = REGULUS.replace("1 0 0 1 1 1", "0.1 0 0 1/10 1 .1")
    (folder / "regulus.txt").write_text(text)
    assert run("transversals", "regulus.txt").json["result"]["counts"]["regulus"] == 1
    (folder / "rounded.txt").write_text(text.replace(" .1", " .1000000000000000055511151231257827"))
    assert "regulus" not in run("transversals", "rounded.txt").json["result"]["counts"]


def test_every_arithmetic_and_its_counts(folder):
    (folder / "skew.txt").write_text(SKEW)
    expected = run("transversals", "skew.txt").json["result"]
    for arithmetic, tier in (("filtered", "filter"), ("exact", "exact"), ("interval", "interval"),
                             ("double", "filter")):
        document = run("transversals", "skew.txt", "--arithmetic", arithmetic).json
        assert document["result"] == expected
        counts = document["stats"]["predicates"]["transversals3"]
        assert counts["calls"] == 1 and counts[tier] == 1


def test_standard_input_and_output_file(folder):
    finished = run("transversals", "-", "-o", "lines.json", stdin=REGULUS)
    assert finished.status == 0 and finished.out == ""
    assert finished.err == "transversals: 0 lines, 1 components\n"
    assert load("lines.json")["result"]["counts"]["components"] == 1


def test_the_order_of_the_input_renames_the_supports(folder):
    (folder / "a.txt").write_text(SKEW)
    x = SKEW.split("\n", 1)[1]
    words = [w for line in x.splitlines() for w in line.split("#")[0].split()]
    objects = [words[6 * i:6 * i + 6] for i in range(4)]
    (folder / "b.txt").write_text("\n".join(" ".join(o) for o in reversed(objects)))
    assert (run("transversals", "a.txt").json["result"]
            == run("transversals", "b.txt").json["result"])


def test_vtk_files(folder):
    (folder / "skew.txt").write_text(SKEW)
    finished = run("transversals", "skew.txt", "--vtk", "lines.vtp")
    assert (finished.status, finished.out) == (0, "")
    assert "VTKFile" in (folder / "lines.vtp").read_text()[:200]
    # SVG knows no depth.
    finished = run("transversals", "skew.txt", "--svg", "lines.svg", "-o", "lines.json")
    assert finished.status == 2 and "SVG knows no depth" in finished.err
    assert not (folder / "lines.json").exists()


def test_triangles(folder):
    # Far apart on the x and y axes in the plane z = 0, and the same again: four bitangents.
    pair = "0 0 0 1 0 0 0 1 0  9 0 0 10 0 0 9 1 0 "
    (folder / "flat.txt").write_text(pair * 2)
    document = run("transversals", "flat.txt", "--triangles").json
    assert document["scene"] == {"files": ["flat.txt"], "triangles": 4}
    assert document["options"]["triangles"] is True
    lines = document["result"]["lines"]
    assert document["result"]["counts"] == {"triangles": 4, "lines": 4, "components": 0}
    pluckers = [entry["plucker"] for entry in lines]
    assert ["1", "0", "0", "0", "0", "0"] in pluckers
    assert all(e["support"][k] // 3 == k for e, k in itertools.product(lines, range(4)))


@pytest.mark.parametrize("text, options, message", [
    ("1 2 three", [],
     "in.txt:1: segment 0: 'three' is no number; write a decimal as 1.5 or 2e-3, or a fraction as 3/7"),
    ("1 2 3\n4 5 6\n7", [], "in.txt:3: the text ends within segment 1; each has 6 numbers"),
    ("# none\n", [], "in.txt: there is no segment; write 6 numbers for each"),
    ("0 0 0 1 1 1 2 2 2", ["--triangles"],
     "in.txt:1: triangle 0: its corners are collinear; move one"),
    ("0 0 0 1 0 0 0 1 0", ["--triangles"],
     "in.txt: 1 triangles are given; tangents are asked of four"),
    ("0 0 0 1 0 0 0 1 0", ["--triangles", "--arithmetic", "double"],
     "--triangles: only exact numbers are used; leave out --arithmetic"),
])
def test_bad_input(folder, text, options, message):
    (folder / "in.txt").write_text(text)
    finished = run("transversals", "in.txt", *options, "-o", "out.json")
    assert (finished.status, finished.err) == (2, f"sightline: {message}\n")
    assert not (folder / "out.json").exists()


def test_missing_file(folder):
    finished = run("transversals", "none.txt")
    assert finished.status == 2
    assert finished.err.startswith("sightline: none.txt: cannot be read (No such file or directory); ")


def test_a_limit_is_kept(folder):
    # All edges of a grid: nearly every four of them are degenerate.
    n = range(5)
    edges = [f"{x} {y} 0 {x} {y} 4" for x in n for y in n]
    edges += [f"{x} 0 {z} {x} 4 {z}" for x in n for z in n]
    edges += [f"0 {y} {z} 4 {y} {z}" for y in n for z in n]
    (folder / "grid.txt").write_text("\n".join(edges))
    finished = run("transversals", "grid.txt", "--limit-seconds", "0.5", "-o", "out.json")
    assert finished.status == 1
    assert finished.err.startswith("sightline: limit reached: more than 0.5 s (--limit-seconds) while ")
    assert not (folder / "out.json").exists()
