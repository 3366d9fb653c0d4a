"""Random cases near degenerate configurations, with an oracle in wider arithmetic."""
