"""How far a deformed surface is from its rest shape."""
