"""Engines of rigid bodies as baselines of ``benchmark``: the machine as their tree of joints."""
