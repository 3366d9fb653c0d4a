"""Random cases near degenerate configurations, checked by arithmetic of higher precision."""
