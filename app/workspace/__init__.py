"""What is open: the surface on screen, what is under the cursor, what colours it."""
