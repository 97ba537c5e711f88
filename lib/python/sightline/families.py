# SPDX-License-Identifier: GPL-3.0-or-later
"""Named scenes: combs, grids, spirals, random polygons… The same name, parameters and seed give the same scene."""

from typing import NamedTuple

from . import _core


class Parameter(NamedTuple):
    """A whole-number parameter of a family."""

    name: str
    default: int
    least: int
    greatest: int


class Family(NamedTuple):
    """A named family of scenes."""

    name: str
    description: str
    parameters: tuple[Parameter, ...]
    degenerate: bool


def all() -> dict[str, Family]:
    """All families by name."""
    return {
        name: Family(name, description, tuple(Parameter(p[0].lower(), *p[1:]) for p in parameters), degenerate)
        for name, description, parameters, degenerate in _core._families()
    }


def generate(name: str, *parameters: int, seed: int = 1, **named: int) -> _core.Scene2:
    """The scene of the named family; parameters by place or by name, the others take their defaults.

    Raises SightlineError with code "bad_parameter".
    """
    values = [int(p) for p in parameters]
    if named:
        family = all().get(name)
        known = [p.name for p in family.parameters] if family else []
        for word in named:
            if word not in known[len(values):]:
                raise TypeError(f"{name} takes {', '.join(known) or 'no parameters'}; not {word}")
        values += [int(named.get(p.name, p.default)) for p in family.parameters[len(values):]]
    return _core._generate(name, [str(v) for v in values], seed)


def generate3(name: str, *parameters: int, seed: int = 1) -> _core.Scene3:
    """The scene of space of the named family (`sightline generate --list`); parameters by place.

    Raises SightlineError with code "bad_parameter".
    """
    return _core._generate3(name, [str(int(p)) for p in parameters], seed)
