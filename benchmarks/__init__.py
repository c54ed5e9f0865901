"""Comparisons anybody can run: `python -m benchmarks.drag`, `python -m benchmarks.survey`."""
