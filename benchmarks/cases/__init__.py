"""Meshes and deformations that benchmarks and tests measure."""
