"""Resolution: whether softness and bending length mean the same on every mesh."""
