"""What the mouse does with each tool in hand."""
