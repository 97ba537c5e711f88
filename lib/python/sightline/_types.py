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
