"""Mesh file formats: bytes to positions and polygons, and back; `table` lists them."""
