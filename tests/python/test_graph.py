# SPDX-License-Identifier: GPL-3.0-or-later
"""Visibility graphs, against the definition; arrays, options and interruption."""

import random
import signal
import threading

import numpy as np
import oracle
import pytest
import sightline

TWO = [[(0, 0), (2, 0), (1, 2)], [(5, 1), (8, 1), (6, 4)]]


@pytest.mark.parametrize("collinear", ["nearest", "all"])
def test_random_scenes_have_the_graph_of_the_definition(collinear):
    generator = random.Random(7)
    for _ in range(60):
        rings = oracle.random_triangles(generator, generator.randrange(1, 6))
        graph = sightline.visibility_graph(sightline.Scene2(rings), collinear=collinear)
        assert graph.edges.tolist() == oracle.visibility_graph(rings, collinear), rings


def test_a_body_edge_through_a_vertex_is_cut_there():
    rings = [[(0, 0), (4, 0), (2, -2)], [(2, 0), (3, 2), (1, 2)]]
    scene = sightline.Scene2(rings)
    nearest, every = (sightline.visibility_graph(scene, collinear=c) for c in ("nearest", "all"))
    assert not nearest.has_edge(0, 1) and nearest.has_edge(0, 3) and nearest.has_edge(1, 3)
    assert every.has_edge(0, 1)


def test_neighbours_edges_and_counts_agree():
    graph = sightline.visibility_graph(sightline.Scene2(TWO))
    assert graph.edge_count == len(graph) == len(graph.edges)
    assert graph.vertex_count == 6
    rows = {(u, v) for u in range(6) for v in graph.neighbours(u).tolist()}
    assert rows == {tuple(e) for e in graph.edges.tolist()} | {(v, u) for u, v in graph.edges.tolist()}
    assert graph.has_edge(1, 0) and not graph.has_edge(0, 0) and not graph.has_edge(0, 99)
    with pytest.raises(IndexError):
        graph.neighbours(6)


def test_arrays_are_views_that_outlive_the_graph():
    edges = sightline.visibility_graph(sightline.Scene2(TWO)).edges
    assert edges.dtype == np.uint32 and edges.shape[1] == 2 and not edges.flags.owndata
    assert edges.tolist() == oracle.visibility_graph(TWO)
    with pytest.raises(ValueError):
        edges[0, 0] = 5


def test_without_body_edges_only_sight_across_remains():
    without = sightline.visibility_graph(sightline.Scene2(TWO), body_edges=False)
    assert without.edges.tolist() == [[u, v] for u, v in oracle.visibility_graph(TWO) if u < 3 <= v]


@pytest.mark.parametrize("options", [{"arithmetic": "exact"}, {"threads": 2}, {"threads": 0}], ids=repr)
def test_the_result_depends_on_the_scene_alone(options):
    scene = sightline.families.generate("grid", 4, 4)
    assert sightline.visibility_graph(scene, **options) == sightline.visibility_graph(scene)


def test_the_tally_tells_which_arithmetic_decided():
    scene = sightline.families.generate("dense", 100, seed=1)
    filtered = sightline.visibility_graph(scene).tally
    exact = sightline.visibility_graph(scene, arithmetic="exact").tally
    for row in [*filtered.values(), *exact.values()]:
        assert row["calls"] == row["filter"] + row["interval"] + row["exact"] + row["undecided"] > 0
        assert row["undecided"] == 0
    assert sum(row["filter"] for row in filtered.values()) > 0
    assert sum(row["exact"] for row in filtered.values()) < sum(row["exact"] for row in exact.values())


@pytest.mark.parametrize("collinear", ["nearest", "all"])
def test_doubles_miss_what_one_ulp_decides(collinear):
    scene = sightline.families.generate("near-collinear", 50, seed=1)
    graphs = {a: sightline.visibility_graph(scene, collinear=collinear, arithmetic=a)
              for a in ("filtered", "exact", "interval", "double")}
    assert graphs["filtered"] == graphs["exact"]
    assert graphs["double"] != graphs["exact"]
    assert graphs["interval"] != graphs["exact"]


def test_tangent_edges_are_edges_and_touch_without_entering():
    scene = sightline.families.generate("dense", 200, seed=5)
    full = {tuple(e) for e in sightline.visibility_graph(scene).edges.tolist()}
    tangent = sightline.visibility_graph(scene, tangent=True).edges.tolist()
    assert 0 < len(tangent) < len(full)
    assert {tuple(e) for e in tangent} <= full


def test_a_limit_on_edges_raises():
    scene = sightline.families.generate("grid", 4, 4)
    edges = sightline.visibility_graph(scene).edge_count
    assert sightline.visibility_graph(scene, max_edges=edges).edge_count == edges
    with pytest.raises(sightline.SightlineError) as caught:
        sightline.visibility_graph(scene, max_edges=edges - 1)
    assert caught.value.code == "limit_reached"


@pytest.mark.parametrize(
    "options", [{"collinear": "some"}, {"arithmetic": "float"}, {"collinear": True}], ids=repr)
def test_unknown_words_raise(options):
    with pytest.raises((ValueError, TypeError)):
        sightline.visibility_graph(sightline.Scene2(TWO), **options)


def test_a_long_build_lets_other_threads_run_and_ends_on_interrupt():
    scene = sightline.families.generate("sparse", 40000, seed=1)
    called = threading.Event()

    def interrupt():  # runs only while the main thread has let go of the interpreter
        called.wait()
        signal.raise_signal(signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        called.set()
        sightline.visibility_graph(scene)
    thread.join()
