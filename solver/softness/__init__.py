"""From softness painted on vertices to the gains of edges."""
