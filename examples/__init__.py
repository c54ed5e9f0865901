"""Short programs, one idea each: README.md beside this file lists them."""
