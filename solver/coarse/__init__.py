"""Frames on a coarse surface, positions on the fine one: for meshes of any size."""
