"""The dressed figure: clothes and small things on the body, each a piece of its own."""
