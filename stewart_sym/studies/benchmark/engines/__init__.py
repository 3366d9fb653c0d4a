"""Rigid-body engines as baselines of ``benchmark``, with the machine as a tree of joints."""
