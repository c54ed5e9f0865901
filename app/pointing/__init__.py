"""What the cursor points at, and what a brush there touches."""
