"""Studies, as tables, pictures and data."""
