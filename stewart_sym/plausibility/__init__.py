"""Plausibility checks of robot files: values that the schema allows but a real machine hardly has."""
