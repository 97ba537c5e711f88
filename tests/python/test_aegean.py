# SPDX-License-Identifier: GPL-3.0-or-later
"""The map of experiments/aegean: what its script promises, and a route on it."""

import importlib.util
import json
import os
import pathlib

import pytest
import sightline

FOLDER = pathlib.Path(os.environ["SIGHTLINE_SOURCE_DIR"]) / "experiments/aegean"


@pytest.fixture(scope="module")
def rings():
    document = json.loads((FOLDER / "aegean.geojson").read_text())
    assert "Natural Earth" in document["source"] and "public domain" in document["licence"]
    return document["features"][0]["geometry"]["coordinates"]


@pytest.fixture(scope="module")
def scene():
    return sightline.Scene2.read(FOLDER / "aegean.geojson", world=True)


def metres(ring):
    return [(round(x * 1000), round(y * 1000)) for x, y in ring[:-1]]


def test_rings_are_simple_and_apart(rings):
    spec = importlib.util.spec_from_file_location("make_aegean", FOLDER / "make_aegean.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    whole = [metres(ring) for ring in rings]
    script.check(whole)
    assert all(script.contains(whole[0], p) for ring in whole[1:] for p in ring)
    assert all(abs(x * 1000 - round(x * 1000)) < 1e-6 for ring in rings for p in ring for x in p)


def test_the_file_is_the_polygon_with_its_holes(rings, scene):
    assert sightline.Scene2([sightline.Polygon2(rings[0], rings[1:])], world=True) == scene


def test_it_is_small_enough_to_keep(rings):
    assert (FOLDER / "aegean.geojson").stat().st_size <= 1_000_000


def test_the_map_has_the_vertices_and_islands_that_its_page_says(scene):
    assert (scene.vertex_count, scene.body_count) == (5521, 66)


def test_the_ship_reaches_rhodes(scene):
    ports = json.loads((FOLDER / "ports.json").read_text(), parse_float=str)
    start, end = (ports["ports"][p]["at"] for p in ports["routes"][0])
    path = sightline.shortest_path(scene, start, end)
    straight = sum((float(a) - float(b)) ** 2 for a, b in zip(start, end)) ** 0.5
    assert straight < path.length[0] <= path.length[1] < 1.1 * straight
    assert sightline.shortest_path(scene, end, start).vertices.tolist() == path.vertices.tolist()[::-1]
