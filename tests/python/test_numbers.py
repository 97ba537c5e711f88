# SPDX-License-Identifier: GPL-3.0-or-later
"""Query points and results cross the border exactly, whatever kind of number they are."""

from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sightline

BOX = [(-9, -9), (9, -9), (9, 9), (-9, 9)]


@pytest.fixture(scope="module")
def room():
    return sightline.Scene2([BOX], world=True)


@pytest.mark.parametrize(
    "number, meaning",
    [
        (0.1, Fraction(0.1)),
        ("0.1", Fraction(1, 10)),
        ("-7/3", Fraction(-7, 3)),
        ("1e-3", Fraction(1, 1000)),
        (Fraction(22, 7), Fraction(22, 7)),
        (Decimal("0.1"), Fraction(1, 10)),
        (3, Fraction(3)),
        (-0.0, Fraction(0)),
        (5e-324, Fraction(5e-324)),
        (np.float64(0.1), Fraction(0.1)),
        (np.float32(0.1), Fraction(float(np.float32(0.1)))),
        (np.int64(-4), Fraction(-4)),
        (np.uint8(4), Fraction(4)),
        (Fraction(1, 3**5000), Fraction(1, 3**5000)),
        (Fraction(-(10**5000) - 1, 10**5000), Fraction(-(10**5000) - 1, 10**5000)),
    ],
    ids=lambda value: type(value).__name__,
)
def test_a_number_is_taken_exactly(room, number, meaning):
    seen = sightline.visibility_polygon(room, (number, 1))
    assert seen.from_point == (meaning, 1)
    assert all(isinstance(c, Fraction) for c in seen.from_point)


@pytest.mark.parametrize("shape", [(1, 2), [1, 2], np.array([1, 2]), np.array([1.0, 2.0])], ids=repr)
def test_a_point_is_any_pair(room, shape):
    assert sightline.visibility_polygon(room, shape).from_point == (1, 2)


@pytest.mark.parametrize(
    "point, error",
    [
        ((float("nan"), 0), ValueError),
        ((float("inf"), 0), ValueError),
        ((Decimal("NaN"), 0), ValueError),
        ((Decimal("Infinity"), 0), OverflowError),
        (("one", 0), ValueError),
        (("1/0", 0), ValueError),
        (("1e99999999999", 0), ValueError),
        (("", 0), ValueError),
        ((True, 0), TypeError),
        ((None, 0), TypeError),
        ((1j, 0), TypeError),
        ((1, 2, 3), TypeError),
        ((1,), TypeError),
        ("12", TypeError),
        (7, TypeError),
    ],
    ids=repr,
)
def test_what_is_no_point_raises(room, point, error):
    with pytest.raises(error):
        sightline.visibility_polygon(room, point)
