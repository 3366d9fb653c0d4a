"""Figures of cost and accuracy made up for tests, and studies without meaningful times."""

import functools

import pytest
from machines import dasgupta
from matplotlib.figure import Figure
from quick_compiler import compile_quickly

from stewart_sym.studies.accuracy import cost as study
from stewart_sym.studies.accuracy import cost_plot
from stewart_sym.studies.accuracy.budget import MARGIN, Budget, papers_motions
from stewart_sym.studies.accuracy.cost import Candidate
from stewart_sym.studies.common import timing
from stewart_sym.studies.common.text_tables import Figures

TOLERANCES = (0.5, 0.05, 0.01, 1e-9)
SCENE = """
schema = 1
robot = "robots/robot.toml"
motions = ["I"]
tolerance = 0.05
margin = 2
rate = 1000.0
"""


def hasty(patch: pytest.MonkeyPatch) -> None:
    """Times without meaning: nothing here depends on them."""
    compile_quickly(patch)
    patch.setattr(timing, "SHORTEST", 1e-7)
    patch.setattr(study, "QUICK_ROUNDS", 1)
    patch.setattr(study, "ROUNDS", 1)
    patch.setattr(study, "MANY", 64)
    patch.setattr(study, "SAMPLED", 2)


def budget(tolerance: float, margin: float = MARGIN, rate: float | None = None) -> Budget:
    return Budget(dasgupta(), {"I": papers_motions()["I"]}, tolerance, margin, rate)


def errors(model: float, model_rms: float, rounding: float) -> Figures:
    return {"model": model, "model_rms": model_rms, "rounding": rounding}


def entry(name: str, operations: int, error: float, ns: float = 100.0) -> Figures:
    times = {"one_pose_ns": ns, "batch_ns": ns / 2}
    found = {
        "operations": operations,
        **times,
        "errors": {"I": errors(error, error / 2, 0.0)},
    }
    return Candidate(*name.split())._asdict() | found


def figures_of(*entries: Figures) -> Figures:
    motions = {"I": {"poses": 61, "peak_force_N": 1000.0}}
    return {"robot": "machine", "motions": motions, "candidates": [*entries], "implementations": []}


CHEAP = entry("exact massless_static float", 400, 0.4)
MIDDLE = entry("exact slender double", 1100, 0.04)
DEAR = entry("exact general double", 2000, 0.0, 300.0)


PEAKS = {"I": 1434.0, "II": 2133.0, "poses.csv": 10.0}
LEVELS = (
    ("exact massless_static", 475, 0.46),
    ("exact massless", 580, 0.23),
    ("exact slender_static", 625, 0.29),
    ("exact general_static", 913, 0.33),
    ("exact slender", 1138, 0.061),
    ("exact point_masses", 1138, 0.061),
    ("exact massless_friction", 1276, 0.23),
    ("exact axisymmetric", 1660, 0.061),
    ("exact slender_friction", 1864, 0.061),
    ("exact point_masses_friction", 1864, 0.061),
    ("exact axisymmetric_friction", 1876, 0.061),
    ("exact frictionless", 1900, 1.3e-5),
    ("paper general", 1978, 0.049),
    ("exact general", 2116, 0.0),
)


def made_up() -> Figures:
    """Figures like those of the paper's machine."""
    entries = []
    for name, operations, off in LEVELS:
        for precision, unit in (("float", 1e-6), ("double", 1e-15)):
            ns = 100.0 * (1 + operations / 2000) * (1.0 if precision == "double" else 0.8)
            of_motions = {
                motion: errors(off * share, 0.3 * off * share, 2 * unit * share)
                for motion, share in (("I", 1.0), ("II", 0.7), ("poses.csv", 0.04))
            }
            entries.append(entry(f"{name} {precision}", operations, off, ns) | {"errors": of_motions})
    others = [
        {"name": name, "ns": ns, "rounding": {"I": 2e-15, "II": 1e-15, "poses.csv": 5e-14}}
        for name, ns in (("every output", 760.0), ("NumPy kernel", 8e3), ("vector reference", 16e3))
    ]
    motions = {name: {"poses": 61, "peak_force_N": peak} for name, peak in PEAKS.items()}
    return figures_of(*entries) | {"motions": motions, "implementations": others}


@functools.cache
def chart() -> Figure:
    """Their picture, whose names take seconds to place."""
    return cost_plot.figure(made_up())
