"""Errors a caller can act on. Each message is one line: what arrived and what was expected."""

from __future__ import annotations


class SolverError(ValueError):
    """Base of every error this package raises about its input."""


class MeshError(SolverError):
    """A mesh, or the file it comes from, cannot be used."""


class FileError(SolverError):
    """A file cannot be read or written."""


class ConstraintError(SolverError):
    """Fixed vertices, handles, targets or transforms do not fit the mesh or each other."""


class MaterialError(SolverError):
    """Softness, gains or a material's name are not usable."""


class FactorizationError(SolverError):
    """A linear system cannot be factorised."""
