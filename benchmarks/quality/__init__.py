"""Quality: the shapes that come out, beside other methods."""
