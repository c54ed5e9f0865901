"""The window: whether it freezes while the solver works."""
