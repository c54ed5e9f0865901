"""Meshes that come with the tool, and the program that makes them."""
