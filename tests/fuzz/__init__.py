"""Input that nobody would write, thrown at readers, sessions and the solver: see `trials`."""
