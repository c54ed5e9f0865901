"""All that touches Polyscope: the order of a frame, input, view and panel."""
