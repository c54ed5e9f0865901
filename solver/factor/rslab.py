"""RSLAB, a supernodal LDL' factorisation: an optional dependency. [Bunch & Kaufman 1977]"""

from __future__ import annotations

import numpy as np
import scipy.sparse as sp

from solver.errors import FactorizationError
from solver.factor.backend import Backend
from solver.types import FloatArray, IntArray

try:
    import rslab
except ImportError:  # as for cvxopt
    rslab = None  # type: ignore[assignment]


class _Rslab:
    """RSLAB takes no order from elsewhere: `order` is let go.

    Minimum fill [Rothberg & Eisenstat 1998] is what its contest of orders chooses up to middle
    sizes; the nested dissection that wins on large ones takes longer to find than it saves.
    """

    def __init__(
        self, rows: IntArray, columns: IntArray, size: int, order: IntArray | None
    ) -> None:
        self._rows, self._columns, self._size = rows, columns, size
        places = self._lower(np.ones(len(rows)))
        # More threads gain little and wait for each other where drawing keeps the processors busy.
        self._symbolic = rslab.analyze(places, "ldlt", ordering="amf", threads=1)

    def factor(self, values: FloatArray) -> _RslabFactor:
        n = self._size
        refusal = f"the {n} x {n} system is not positive definite"
        try:
            factor = self._symbolic.factor(self._lower(values).data)
        except RuntimeError as failure:
            raise FactorizationError(f"{refusal} ({failure})") from failure
        _, negative, zero = factor.inertia  # LDL' itself is content with any sign
        if negative or zero:
            raise FactorizationError(f"{refusal} ({negative} negative pivots, {zero} zero)")
        return _RslabFactor(factor)

    def _lower(self, values: FloatArray) -> sp.csc_array:
        """The lower triangle, column by column and each sorted, as RSLAB keeps its values."""
        shape = (self._size, self._size)
        return sp.csc_array(sp.coo_array((values, (self._rows, self._columns)), shape=shape))


class _RslabFactor:
    def __init__(self, factor: rslab.Ldlt) -> None:
        self._factor = factor

    def solve(self, B: FloatArray) -> FloatArray:
        if not B.size:
            return np.zeros_like(B)
        return np.asarray(self._factor.solve_many(np.ascontiguousarray(B)))


BACKEND = None if rslab is None else Backend("rslab", _Rslab)
