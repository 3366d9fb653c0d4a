"""What a machine can do, and what a motion needs: workspace, capability, sizing."""
