"""Speed: what a bind and a drag cost, beside other programs."""
