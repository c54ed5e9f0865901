from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.app.person import Person, slab


@pytest.fixture
def bar() -> Iterator[Person]:
    """20 x 4 x 2, nothing painted."""
    person = Person(slab(20, 4, 2.0))
    yield person
    person.editor.close()


@pytest.fixture
def ready(bar: Person) -> Person:
    """The bar, its left end fixed, its right end a handle, the drag tool in the hand."""
    bar.ready_bar()
    return bar
