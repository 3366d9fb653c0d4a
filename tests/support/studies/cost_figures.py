"""Figures of cost and accuracy made up for tests, and studies without meaningful times."""

import pytest
from machines import dasgupta
from quick_compiler import compile_quickly

from stewart_sym.generated.fidelities import FIDELITIES as TABLE
from stewart_sym.studies.accuracy import cost as study
from stewart_sym.studies.accuracy.budget import MARGIN, Budget, papers_motions
from stewart_sym.studies.accuracy.cost import Candidate, CostAccuracy, Entry, Errors
from stewart_sym.studies.common import timing

FRICTIONLESS = TABLE["frictionless"]["operations"]["total"]
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
    """Times without meaning, and no sizes: nothing here depends on them."""
    compile_quickly(patch)
    patch.setattr(timing, "SHORTEST", 1e-7)
    patch.setattr(study, "QUICK_ROUNDS", 1)
    patch.setattr(study, "ROUNDS", 1)
    patch.setattr(study, "MANY", 64)
    patch.setattr(study, "SAMPLED", 4)
    patch.setattr(study, "text_size", lambda *_: None)


def budget(tolerance: float, margin: float = MARGIN, rate: float | None = None) -> Budget:
    return Budget(dasgupta(), {"I": papers_motions()["I"]}, tolerance, margin, rate)


def entry(name: str, operations: int, error: float, ns: float = 100.0) -> Entry:
    formulation, level, precision = name.split()
    errors = {"I": Errors(error, error / 2, 0.0)}
    return Entry(Candidate(formulation, level, precision), operations, (ns,), (ns / 2,), 1000, errors)


def made_up(*entries: Entry) -> CostAccuracy:
    return CostAccuracy("machine", {"I": 1000.0}, {"I": 61}, entries)


CHEAP = entry("exact massless_static float", 400, 0.4)
MIDDLE = entry("exact slender double", 1100, 0.04)
DEAR = entry("exact general double", 2000, 0.0, 300.0)
