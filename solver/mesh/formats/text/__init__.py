"""Text files as arrays of bytes: their lines, words and numbers, read and replaced."""
