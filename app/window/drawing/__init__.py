"""The scene in Polyscope."""
