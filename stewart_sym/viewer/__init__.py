"""A machine and its motion as one HTML file that is looked at in a browser, without a network."""
