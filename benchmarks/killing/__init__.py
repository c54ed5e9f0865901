"""What kill -9 costs, at any moment."""
