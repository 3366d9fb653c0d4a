"""Reports and pictures of workspaces and of sizing."""
