"""Regions marked in seconds, with real mouse and keys: a limb, a lasso, a double click."""

from __future__ import annotations

import numpy as np

from .scene import Scene

ARM = (0.3, 1.42, 0.05)


def test_everything_but_an_arm_is_fixed_in_two_actions(mannequin: Scene) -> None:
    scene, person = mannequin, mannequin.person
    person.key("2")
    person.choose("limb", 0.1)
    scene.stroke(ARM)
    person.key("ctrl+i")
    fixed = scene.save_session()["fixed"]
    x = scene.rest[:, 0]
    assert set(np.flatnonzero(x < 0.15)) <= set(fixed)
    assert x[fixed].max() < 0.3
    person.key("ctrl+z")
    person.key("ctrl+z")
    assert scene.save_session()["fixed"] == []


def test_a_lasso_takes_what_is_seen_and_a_double_click_everything(mannequin: Scene) -> None:
    scene, person = mannequin, mannequin.person
    person.key("2")
    person.choose("lasso", 0.1)
    around = [(-0.3, 1.9, 0), (0.3, 1.9, 0), (0.25, 1.56, 0), (-0.25, 1.56, 0), (-0.3, 1.85, 0)]
    view = scene.silhouette()
    scene.stroke(*around)
    assert scene.looks_as(view), "no orbit"
    fixed = scene.save_session()["fixed"]
    y, z = scene.rest[fixed, 1], scene.rest[fixed, 2]
    assert y.min() > 1.5
    assert z.max() > 0.09
    head = scene.rest[scene.rest[:, 1] > 1.62]
    back = head[head[:, 2] < -0.08]
    assert len(back) > 20
    assert z.min() > -0.08, "nothing on the far side"
    (chest,) = scene.pixels([(0.0, 1.2, 0.1)])
    person.double_click(*chest)
    assert len(scene.save_session()["fixed"]) == len(scene.rest)
    person.key("ctrl+z")
    assert scene.save_session()["fixed"] == fixed
    person.choose("brush", 0.1)
    person.scroll(*chest, 3, hold="ctrl")
    assert scene.looks_as(view), "no zoom"
