"""Engines of rigid bodies as baselines of ``bench``: the machine as their tree of joints."""
