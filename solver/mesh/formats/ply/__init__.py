"""PLY files, text and binary: rows of named properties after a header that declares them."""
