"""glTF and GLB files: scenes of meshes, kept whole but for what a deformation changes."""
