from __future__ import annotations

from collections.abc import Iterator

import pytest

from app.worker.client import ProcessWorker


@pytest.fixture
def solver_process() -> Iterator[ProcessWorker]:
    made = ProcessWorker()
    yield made
    made.close()
