"""Reading and writing files: what is asked first, where they go."""
