"""Path planning between via poses, path parameterization within limits, and certificates of plans."""
