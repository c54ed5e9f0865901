"""What is drawn, as data: the surface, borders of regions, lines and words over it."""
