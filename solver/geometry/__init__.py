"""Surfaces as geometry: topology, fundamental forms, cotangents, Laplacian, rotations."""
