"""Viewer: a robot and its motion as one HTML file for a browser, without a network."""
