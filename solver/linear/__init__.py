"""The quadratic energy as a linear system: assembled, factorised, and its basis for a drag."""
