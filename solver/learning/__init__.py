"""Softness learned from examples: poses of the same mesh."""
