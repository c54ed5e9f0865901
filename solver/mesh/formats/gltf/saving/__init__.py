"""Saving glTF: a copy of the file that was read, edited where a deformation changes it."""
