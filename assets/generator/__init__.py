"""How the meshes here are made: implicit solids, primitives, quads, and their text."""
