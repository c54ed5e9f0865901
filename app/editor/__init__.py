"""The whole application without its window: commands and what they do."""
