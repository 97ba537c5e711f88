# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact visibility in the plane and in space: what sees what, from where.

    >>> import sightline
    >>> scene = sightline.Scene2(polygons=[[(0, 0), (2, 0), (1, 2)], [(5, 1), (8, 1), (6, 4)]])
    >>> graph = sightline.visibility_graph(scene)
    >>> graph.edges.shape
    (11, 2)

Coordinates of scenes are doubles, taken as the exact rational numbers that they are.
Query points are exact: float, int, Fraction, Decimal, or text such as "0.1" and "1/3".
Results are exact too, as fractions.Fraction; only what is called `approx_…` is rounded, for drawing.
"""

from . import families
from ._core import (
    PointVisibility2,
    Polygon2,
    Scene2,
    Scene3,
    ShortestPath,
    VisibilityGraph,
    VisibilityPolygon,
    VisibilitySkeleton,
    info,
    read_scene3,
    shortest_path,
    skeleton,
    visibility_graph,
    visibility_polygon,
)
from ._core import __version__
from ._types import (
    ContractViolation,
    Direction,
    RepairWarning,
    Ring,
    SightlineError,
    SkeletonArc,
    SkeletonNode,
    Surd,
)

__all__ = [
    "ContractViolation",
    "Direction",
    "PointVisibility2",
    "Polygon2",
    "RepairWarning",
    "Ring",
    "Scene2",
    "Scene3",
    "ShortestPath",
    "SightlineError",
    "SkeletonArc",
    "SkeletonNode",
    "Surd",
    "VisibilityGraph",
    "VisibilityPolygon",
    "VisibilitySkeleton",
    "families",
    "info",
    "read_scene3",
    "shortest_path",
    "skeleton",
    "visibility_graph",
    "visibility_polygon",
]
