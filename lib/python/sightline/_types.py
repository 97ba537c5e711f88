# SPDX-License-Identifier: GPL-3.0-or-later
"""The small types of the module that are plain Python."""

from fractions import Fraction
from typing import NamedTuple


class SightlineError(Exception):
    """Bad data, a question without an answer, or a limit.

    `code` is the machine's word for it (`"self_intersection"`, `"inside_body"`, `"unreachable"`…), the
    message one line for people that names the place.
    """

    def __init__(self, code: str, message: str) -> None:
        super().__init__(message)
        self.code = code

    def __reduce__(self):
        return type(self), (self.code, str(self))


class ContractViolation(Exception):
    """The library was called in a way that its documentation excludes."""


class RepairWarning(UserWarning):
    """What `repair=True` did to make a scene valid; one warning a change."""


class Direction(NamedTuple):
    """A vertex at infinity: the direction in which it lies."""

    x: Fraction
    y: Fraction


class Ring(NamedTuple):
    """A closed chain of a scene: numbers of its vertices, with the interior of the bodies on the left."""

    vertices: "numpy.ndarray"
    body: int | None
    is_hole: bool


class Surd(NamedTuple):
    """a + b √c with b = ±1: an irrational number of a quadratic field."""

    a: Fraction
    b: int
    c: Fraction

    def __float__(self) -> float:
        return float(self.a) + self.b * float(self.c) ** 0.5


End = list[tuple[int, bool]] | None


class SkeletonNode(NamedTuple):
    """A line of sight that touches so much that it cannot move."""

    type: str
    vertices: list[int]
    edges: list[tuple[int, int]]
    along: list[tuple[int, int]]
    #: Faces (by input number, with whether the back is hit) at both ends; None at infinity.
    ends: tuple[End, End]
    faces: list[int]
    root: int | None


class SkeletonArc(NamedTuple):
    """A sweep of lines of sight between two nodes."""

    type: str
    vertices: list[int]
    edges: list[tuple[int, int]]
    ends: tuple[End, End]
    nodes: tuple[int, int]
