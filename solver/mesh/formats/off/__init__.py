"""OFF files: text, kept to the byte but for what a deformation changes."""
