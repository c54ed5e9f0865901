"""The pictures of the documents, and who makes them: a table of scenes in each module."""
