"""The interactive tool: everything about painting and dragging; `solver` does the mathematics."""
