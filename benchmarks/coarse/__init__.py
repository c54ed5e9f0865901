"""Coarse frames against the exact solution: the measurements of docs/coarse.md."""
