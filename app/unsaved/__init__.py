"""Work that nobody has saved yet: kept in time, offered at the next start."""
