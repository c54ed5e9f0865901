"""Which vertices a person means: inside a loop, in sight, of a limb, around a region."""
