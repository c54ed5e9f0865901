"""Meshes as files hold them: polygons, normals, formats."""
