# SPDX-License-Identifier: GPL-3.0-or-later
"""Named families, with parameters by place and by name."""

import pytest
import sightline


def test_every_family_makes_a_scene_with_its_defaults():
    families = sightline.families.all()
    assert {"grid", "comb", "spiral"} <= set(families)
    for name in families:
        assert sightline.families.generate(name, seed=3).vertex_count > 0, name


def test_the_same_seed_gives_the_same_scene_and_another_one_another():
    scenes = [sightline.families.generate("star", 9, seed=s) for s in (1, 1, 2)]
    assert scenes[0] == scenes[1]
    assert scenes[0] != scenes[2]


def test_parameters_by_place_and_by_name_are_the_same():
    parameters = sightline.families.all()["grid"].parameters
    assert [p.name for p in parameters] == ["columns", "rows"]
    by_place = sightline.families.generate("grid", 2, 3)
    assert by_place.body_count == 6
    assert sightline.families.generate("grid", rows=3, columns=2) == by_place
    assert sightline.families.generate("grid", 2, rows=3) == by_place


def test_an_unknown_family_and_a_wrong_parameter_raise():
    for call in (lambda: sightline.families.generate("gird"),
                 lambda: sightline.families.generate("grid", 1, 2, 3, 4)):
        with pytest.raises(sightline.SightlineError) as caught:
            call()
        assert caught.value.code == "bad_parameter"
    with pytest.raises(TypeError, match="columns, rows"):
        sightline.families.generate("grid", sides=4)
    with pytest.raises(TypeError, match="columns"):
        sightline.families.generate("grid", 2, columns=4)
