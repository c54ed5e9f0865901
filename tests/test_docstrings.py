"""The examples in the docstrings: every public name has one, and each does what it says."""

from __future__ import annotations

import doctest
import inspect
from pathlib import Path

import numpy as np
import pytest

import solver

# PRESETS is data, without a docstring of its own: Material's example shows it.
PUBLIC = sorted(set(solver.__all__) - {"PRESETS"})
EXAMPLES = {
    test.name: test
    for name in PUBLIC
    for test in doctest.DocTestFinder().find(getattr(solver, name), name, globs={})
    if test.examples
}


def methods(cls: type) -> list[str]:
    """A class's own public functions, as `Class.function`; a property needs no example."""
    kinds = (staticmethod, classmethod)
    return [
        f"{cls.__name__}.{name}"
        for name, value in vars(cls).items()
        if not name.startswith("_") and (inspect.isfunction(value) or isinstance(value, kinds))
    ]


@pytest.mark.parametrize(
    "name", PUBLIC + methods(solver.Deformer) + methods(solver.Drag) + methods(solver.Mesh)
)
def test_every_public_name_has_an_example(name: str) -> None:
    assert name in set(EXAMPLES)


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_an_example_does_what_it_says(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With NumPy imported as np. A method's example goes on from that of its class."""
    monkeypatch.chdir(tmp_path)
    names = {"np": np}
    report: list[str] = []
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    for part in dict.fromkeys([name.partition(".")[0], name]):
        test = EXAMPLES[part]
        test.globs = names
        runner.run(test, out=report.append, clear_globs=False)
    assert not report, "".join(report)
