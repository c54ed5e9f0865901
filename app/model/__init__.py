"""What a person decided about one mesh, its history, and the session file that keeps it."""
