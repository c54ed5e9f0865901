"""Other programs that deform meshes, each in a process of its own where it is installed."""
