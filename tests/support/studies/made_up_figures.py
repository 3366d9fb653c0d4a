"""Made-up figures of cost and accuracy."""

import functools

from matplotlib.figure import Figure

from stewart_sym.studies.accuracy import cost_plot
from stewart_sym.studies.accuracy.cost import Candidate, CostAccuracy, Entry, Errors, Implementation

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


def made_up() -> CostAccuracy:
    """Figures like those of the paper's machine."""
    entries = []
    for name, operations, off in LEVELS:
        for precision, unit in (("float", 1e-6), ("double", 1e-15)):
            formulation, level = name.split()
            ns = 100.0 * (1 + operations / 2000) * (1.0 if precision == "double" else 0.8)
            errors = {
                motion: Errors(off * share, 0.3 * off * share, 2 * unit * share)
                for motion, share in (("I", 1.0), ("II", 0.7), ("poses.csv", 0.04))
            }
            entries.append(
                Entry(Candidate(formulation, level, precision), operations, (ns,), (ns / 2,), 9000, errors)
            )
    others = [
        Implementation(name, (ns,), {"I": 2e-15, "II": 1e-15, "poses.csv": 5e-14})
        for name, ns in (("every output", 760.0), ("NumPy kernel", 8e3), ("vector reference", 16e3))
    ]
    peaks = {"I": 1434.0, "II": 2133.0, "poses.csv": 10.0}
    return CostAccuracy("machine", peaks, dict.fromkeys(peaks, 61), tuple(entries), tuple(others))


@functools.cache
def chart() -> Figure:
    """Their picture, whose names take seconds to place."""
    return cost_plot.figure(made_up())
