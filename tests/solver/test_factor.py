"""One interface, several factorisations."""

from __future__ import annotations

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
import scipy.sparse as sp

from solver import Deformer, FactorizationError
from solver.factor import BACKENDS, analyse, factorize, table
from solver.factor.backend import Backend
from solver.geometry.laplacian import cotangent_laplacian
from solver.geometry.motions import motion, rotation
from tests.solver import shapes

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(params=["cholmod", "rslab", "splu"])
def backend(request: pytest.FixtureRequest) -> str:
    return named(request.param).name


def named(name: str) -> Backend:
    found = [backend for backend in BACKENDS if backend.name == name]
    if not found:
        pytest.skip(f"{name} is not installed")
    return found[0]


def matrix(shift: float = 0.1) -> sp.csc_array:
    V, F = shapes.bumpy_plane(12)
    return sp.csc_array(cotangent_laplacian(V, F) + shift * sp.eye_array(len(V)))


def test_solves(backend: str) -> None:
    A = matrix()
    B = np.random.default_rng(0).normal(size=(A.shape[0], 4))
    factor = factorize(A, backend=backend)
    for columns in (B, np.asfortranarray(B), B[:, :1], B[:, ::2]):
        before = columns.copy()
        np.testing.assert_allclose(A @ factor.solve(columns), columns, atol=1e-11)
        np.testing.assert_array_equal(columns, before)


def test_takes_an_order(backend: str) -> None:
    A = matrix()
    B = np.random.default_rng(1).normal(size=(A.shape[0], 3))
    order = np.random.default_rng(2).permutation(A.shape[0])
    np.testing.assert_allclose(A @ factorize(A, order, backend).solve(B), B, atol=1e-11)


def test_one_analysis_serves_factors_of_several_values(backend: str) -> None:
    one, two = sp.tril(matrix(0.1), format="coo"), sp.tril(matrix(5.0), format="coo")
    n = one.shape[0]
    rows, columns = (index.astype(np.int64) for index in one.coords)
    analysis = analyse(rows, columns, n, None, backend)
    B = np.random.default_rng(1).normal(size=(n, 3))
    first, second = analysis.factor(one.data), analysis.factor(two.data)
    for _ in range(2):  # in turn: neither may see the other's numbers
        np.testing.assert_allclose(matrix(0.1) @ first.solve(B), B, atol=1e-11)
        np.testing.assert_allclose(matrix(5.0) @ second.solve(B), B, atol=1e-11)


def test_a_factor_survives_one_that_fails(backend: str) -> None:
    lower = sp.tril(matrix(), format="coo")
    rows, columns = (index.astype(np.int64) for index in lower.coords)
    analysis = analyse(rows, columns, lower.shape[0], None, backend)
    factor = analysis.factor(lower.data)
    with shapes.refuses(FactorizationError, "144 x 144 system"):
        analysis.factor(np.zeros_like(lower.data))
    B = np.ones((lower.shape[0], 1))
    np.testing.assert_allclose(matrix() @ factor.solve(B), B, atol=1e-11)


def test_values_at_a_place_named_twice_add_up(backend: str) -> None:
    rows, columns = np.array([0, 1, 1, 1, 1]), np.array([0, 0, 1, 0, 1])
    factor = analyse(rows, columns, 2, None, backend).factor(np.array([4.0, 1, 2, 0.5, 1]))
    A = np.array([[4, 1.5], [1.5, 3]])
    np.testing.assert_allclose(A @ factor.solve(np.eye(2)), np.eye(2), atol=1e-14)


def test_nothing_to_solve(backend: str) -> None:
    factor = factorize(sp.csc_array((0, 0)), backend=backend)
    assert factor.solve(np.empty((0, 3))).shape == (0, 3)


def test_no_columns_to_solve(backend: str) -> None:
    A = matrix()
    n = A.shape[0]
    assert factorize(A, backend=backend).solve(np.empty((n, 0))).shape == (n, 0)


def test_refuses_a_singular_matrix(backend: str) -> None:
    loose = sp.block_diag([matrix(), sp.csc_array((2, 2))], format="csc")
    with shapes.refuses(FactorizationError, "146 x 146 system"):
        factorize(sp.csc_array(loose), backend=backend)


@pytest.mark.parametrize("backend", ["cholmod", "rslab"])  # SuperLU looks at no signs
@pytest.mark.parametrize("shift", [-1e-8, -1.0])
def test_refuses_an_indefinite_matrix(backend: str, shift: float) -> None:
    with shapes.refuses(FactorizationError, "144 x 144 system is not positive definite"):
        factorize(matrix(shift), backend=named(backend).name)


def test_threads_do_not_mix_factors(backend: str) -> None:
    lower = sp.tril(matrix(), format="coo")
    rows, columns = (index.astype(np.int64) for index in lower.coords)
    analysis = analyse(rows, columns, lower.shape[0], None, backend)
    B = np.random.default_rng(1).normal(size=(lower.shape[0], 4))

    def residual(times: float) -> float:
        solved = analysis.factor(times * lower.data).solve(B)
        return float(np.abs(times * (matrix() @ solved) - B).max())

    with ThreadPoolExecutor(3) as pool:
        assert max(pool.map(residual, np.arange(1.0, 13.0))) < 1e-10


def deform() -> list[np.ndarray]:
    V, F = shapes.tube()
    softness = np.clip(1 - np.abs(V[:, 0] - 4), 0, 1)
    left, right = np.flatnonzero(V[:, 0] < 1), np.flatnonzero(V[:, 0] > 7)
    first = Deformer(V, F, left, [right])
    deformer = first.rebind(softness=softness).grab(np.exp(-((V[:, 0] - 4) ** 2)))
    T = [motion(rotation([0, 0, 1], 60), [-1, 2, 0], [8, 0, 0]), np.eye(4)]
    return [deformer.pose(T), deformer.pose(T, rigid=2), deformer.solve(V[right] + 1)]


@pytest.mark.parametrize("other", ["rslab", "splu"])
def test_all_deform_alike(other: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(table, "BACKENDS", (named("cholmod"),))
    with_cholmod = deform()
    monkeypatch.setattr(table, "BACKENDS", (named(other),))
    for one, two in zip(with_cholmod, deform(), strict=True):
        np.testing.assert_allclose(one, two, atol=1e-8)


PROGRAM = """
import sys; sys.modules.update(dict.fromkeys({hidden}))
import numpy as np, solver, solver.factor
assert [b.name for b in solver.factor.BACKENDS] == {names}
V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])
d = solver.Deformer(V, [[0, 1, 2], [1, 3, 2]], [0], [[3]])
print(d.pose([np.eye(4)])[3].tolist())
"""


def output(program: str) -> str:
    """What a program prints in an interpreter of its own, which must not complain."""
    run = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert (run.returncode, run.stderr) == (0, "")
    return run.stdout.strip()


@pytest.mark.parametrize(
    ("hidden", "expected"),
    [
        (["cvxopt", "kvxopt"], ["rslab", "splu"]),
        (["cvxopt", "kvxopt", "rslab"], ["splu"]),
        (["rslab"], ["cholmod", "splu"]),
    ],
)
def test_works_without(hidden: list[str], expected: list[str]) -> None:
    for name in expected:
        named(name)
    assert output(PROGRAM.format(hidden=hidden, names=expected)) == "[1.0, 1.0, 0.0]"


def test_kvxopt_stands_in_for_cvxopt() -> None:
    """All the tests above of CHOLMOD, with cvxopt hidden."""
    pytest.importorskip("kvxopt")
    program = (
        "import sys, pytest; sys.modules['cvxopt'] = None\n"
        "sys.exit(pytest.main(['-q', 'tests/solver/test_factor.py', '-k', 'cholmod or alike']))\n"
    )
    assert "skipped" not in output(program)
