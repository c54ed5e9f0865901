"""Errors a caller can act on. Each message is one line: what arrived and what was expected."""

from __future__ import annotations


class SolverError(ValueError):
    """Base of every error this package raises about its input.

    >>> import solver
    >>> try:
    ...     solver.Material(bending=0, stretching=1)
    ... except solver.SolverError as error:
    ...     print(error)
    material's bending gain must be from 1e-06 to 1e+06, got 0
    """


class MeshError(SolverError):
    """A mesh, or the file it comes from, cannot be used.

    >>> import solver
    >>> solver.load_mesh("mesh.txt")
    Traceback (most recent call last):
    solver.errors.MeshError: mesh.txt: unknown mesh format '.txt', expected ...
    """


class FileError(SolverError):
    """A file cannot be read or written.

    >>> import solver
    >>> solver.load_mesh("missing.obj")
    Traceback (most recent call last):
    solver.errors.FileError: missing.obj: cannot be read: No such file or directory
    """


class ConstraintError(SolverError):
    """Fixed vertices, handles, targets or transforms do not fit the mesh or each other.

    >>> import solver
    >>> solver.Deformer([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], fixed=[3])
    Traceback (most recent call last):
    solver.errors.ConstraintError: fixed ...
    """


class MaterialError(SolverError):
    """Softness, gains or a material's name are not usable.

    >>> import solver
    >>> V, F = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]
    >>> solver.Deformer(V, F, fixed=[0], material="steel")
    Traceback (most recent call last):
    solver.errors.MaterialError: unknown material 'steel', expected one of hinge, paper, clay
    """


class FactorizationError(SolverError):
    """A linear system cannot be factorised.

    >>> from scipy.sparse import csc_array
    >>> from solver.factor import factorize
    >>> factorize(csc_array([[1.0, 1.0], [1.0, 1.0]]))  # singular
    Traceback (most recent call last):
    solver.errors.FactorizationError: ...
    """
