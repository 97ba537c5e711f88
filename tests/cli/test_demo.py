# SPDX-License-Identifier: GPL-3.0-or-later
"""The demo of the Aegean Sea, as `make demo` runs it: files, table, and what is known of the map."""

import json
import os
import pathlib
import subprocess
from fractions import Fraction

import pytest

ROOT = pathlib.Path(os.environ["SIGHTLINE_SOURCE_DIR"])
ROUTES = ("piraeus-rhodes", "thessaloniki-heraklion")


@pytest.fixture(scope="module")
def demo(tmp_path_factory):
    out = tmp_path_factory.mktemp("aegean")
    done = subprocess.run([ROOT / "experiments/aegean/demo.sh", os.environ["SIGHTLINE_PROGRAM"], out],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return out, done.stdout


def result(folder, name):
    return json.loads((folder / f"{name}.json").read_text())


def test_graphs_are_written_as_json_vtp_and_svg(demo):
    out, _ = demo
    full, tangent = result(out, "graph"), result(out, "tangent")
    assert full["kind"] == tangent["kind"] == "visibility_graph"
    assert (full["scene"]["vertices"], full["scene"]["bodies"]) == (5521, 66)
    edges = {tuple(e) for e in full["result"]["edges"]}
    assert {tuple(e) for e in tangent["result"]["edges"]} < edges
    assert "<VTKFile" in (out / "graph.vtp").read_text(errors="replace")[:200]
    assert "<svg" in (out / "graph.svg").read_text()[:500]


@pytest.mark.parametrize("name", ROUTES)
def test_routes_run_along_edges_of_the_tangent_graph(demo, name):
    out, _ = demo
    route = result(out, name)["result"]
    edges = {tuple(e) for e in result(out, "tangent")["result"]["edges"]}
    assert all((min(u, v), max(u, v)) in edges
               for u, v in zip(route["vertices"], route["vertices"][1:]))
    length = route["length"]
    assert Fraction(length["lower"]) <= length["approx_value"] <= Fraction(length["upper"])
    assert "<VTKFile" in (out / f"{name}.vtp").read_text(errors="replace")[:200]
    assert "<svg" in (out / f"{name}.svg").read_text()[:500]


def test_pictures_are_png_where_there_is_vtk(demo):
    out, said = demo
    if "without VTK" in said:
        assert not list(out.glob("*.png"))
        return
    for name in ("map", *ROUTES):
        assert (out / f"{name}.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")


def test_the_table_shows_counts_lengths_and_tiers(demo):
    out, said = demo
    edges = len(result(out, "graph")["result"]["edges"])
    assert f"{edges:,} edges" in said
    for name in ROUTES:
        assert f"{result(out, name)['result']['length']['approx_value']:.3f} km" in said
    counts = result(out, "graph")["stats"]["predicates"]["orientation2"]
    (row,) = [line for line in said.splitlines() if f"{counts['calls']:,}" in line]
    assert [int(n.replace(",", "")) for n in row.split()[1:]] == [
        counts[t] for t in ("calls", "filter", "interval", "exact", "undecided")]
