"""Handles turned and moved exactly: the gizmo, the operators on keys, numbers typed meanwhile."""
