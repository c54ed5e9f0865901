"""Unsaved work at both ends of a window."""
