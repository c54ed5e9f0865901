"""How much softness that is learned from some poses helps with others."""
