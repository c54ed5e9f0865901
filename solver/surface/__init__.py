"""From the mesh that is shown to the surface that is solved, and back."""
