"""The levels of `rigid`: from linear frames to rotations, and back to positions."""
