# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures with matplotlib. Each function draws on `axes` and returns them."""

import numpy as np


def _axes(axes):
    if axes is None:
        import matplotlib.pyplot as plt

        axes = plt.gca()
    axes.set_aspect("equal")
    return axes


def scene(scene, axes=None, *, body="#c4c8ce", free="white", outline="#484f59", linewidth=0.6):
    """The bodies of a scene, the outside of its world, its walls and points."""
    from matplotlib.collections import LineCollection
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    axes = _axes(axes)

    def path(rings):
        return Path.make_compound_path(
            *(Path(np.vstack([scene.vertices[r.vertices], scene.vertices[r.vertices[:1]]]), closed=True)
              for r in rings)
        )

    world = [r for r in scene.rings if r.body is None]
    if world:
        axes.set_facecolor(body)
        axes.add_patch(PathPatch(path(world), facecolor=free, edgecolor=outline, linewidth=linewidth))
    by_body = {}
    for ring in scene.rings:
        if ring.body is not None:
            by_body.setdefault(ring.body, []).append(ring)
    for rings in by_body.values():
        axes.add_patch(PathPatch(path(rings), facecolor=body, edgecolor=outline, linewidth=linewidth))
    walls = scene.walls
    if len(walls):
        axes.add_collection(LineCollection(scene.vertices[walls], colors=outline, linewidths=2 * linewidth))
    if len(scene.points):
        axes.plot(*scene.vertices[scene.points].T, "o", color=outline, markersize=3)
    axes.autoscale_view()
    return axes


def graph(scene, graph, axes=None, *, color="#0072b2", linewidth=0.4, alpha=0.5):
    """The edges of a visibility graph."""
    from matplotlib.collections import LineCollection

    axes = _axes(axes)
    axes.add_collection(
        LineCollection(scene.vertices[graph.edges], colors=color, linewidths=linewidth, alpha=alpha)
    )
    axes.autoscale_view()
    return axes


def view(polygon, axes=None, *, color="#e69f00", alpha=0.4):
    """A bounded visibility polygon and its viewpoint."""
    if not polygon.is_bounded:
        raise ValueError("the polygon is unbounded: give the scene a world to draw what is seen")
    axes = _axes(axes)
    axes.fill(*polygon.approx_ring.T, color=color, alpha=alpha, linewidth=0)
    axes.plot(*(float(c) for c in polygon.from_point), "o", color=color, markersize=5)
    return axes


def path(path, axes=None, *, color="#d55e00", linewidth=1.5):
    """A shortest path."""
    axes = _axes(axes)
    axes.plot(*path.approx_points.T, "-o", color=color, linewidth=linewidth, markersize=2.5)
    return axes
