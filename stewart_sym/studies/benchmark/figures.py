"""The figures of ``bench`` as JSON takes them: ratios that are made of times, targets."""

from collections.abc import Mapping, Sequence

from ..common.output import Figures
from .samples import CLOSED, DERIVATIVES, FORWARD, PLAIN, builds_of, named, quickest

MOST = {FORWARD: (2.0,), DERIVATIVES: (8.0, 5.0)}
"""Targets: the most that a function may take, in times of inverse dynamics; and the goal beyond."""

TIMES_FASTER = 20.0
"""Target: how many times as fast as the better baseline forward dynamics is to be."""


def ratios(found: Figures, time: float, instructions: str = "") -> dict[str, float]:
    """A time, ns, over the medians of CasADi's closed form and of its plain C; nothing without CasADi.

    instructions: for which these are compiled; empty for the quickest, which the baselines have.
    """
    of = {}
    for key, name in (("ratio_to_closed_form", CLOSED), ("ratio_to_casadi", PLAIN)):
        if instructions:
            of[key] = quickest(builds_of(found, name, instructions))
        else:
            of[key] = named(found["baselines"], name)
    return {key: time / each["median"] for key, each in of.items() if each is not None}


def with_ratios(found: Figures) -> Figures:
    """A run's times of the forces and of all C, in cycles of its clock as well, and over CasADi's."""

    def entry(figure: Figures, instructions: str = "") -> Figures:
        time = figure["median"]
        return {**figure, "cycles": time / found["cycle"]["median"], **ratios(found, time, instructions)}

    return found | {
        "ours": [entry(each) for each in found["ours"]],
        "baselines": [entry(each) for each in found["baselines"]],
        "builds": [entry(each, each["instructions"]) for each in found["builds"]],
    }


def flatness(sweep: Sequence[Figures]) -> dict[str, float]:
    """By name, the longest time per pose over all batch sizes, divided by the shortest."""
    medians: dict[str, list[float]] = {}
    for each in sweep:
        medians.setdefault(each["name"], []).append(each["median"])
    return {name: max(of_name) / min(of_name) for name, of_name in medians.items()}


def motion_figures(
    robot: str,
    ours: Sequence[Figures],
    baselines: Sequence[Figures],
    calls: Sequence[Figures],
    empty: Sequence[Figures],
    opened: float | None,
    differences: Mapping[str, float],
) -> Figures:
    """Equations of motion, one pose, with ratios and targets.

    ours: the first of which ratios refer to. baselines: those installed. calls, empty: what each baseline's
    figure is the difference of, a call from Python and one over nothing. opened: m, how far MuJoCo's loops
    are open, None without it. differences: by program, from the reference's numbers, share of a pose's
    largest.
    """
    inverse, better = ours[0]["median"], quickest(baselines)
    (forward,) = (each["median"] for each in ours if each["name"] == FORWARD)

    def entry(figure: Figures) -> Figures:
        targets = dict(zip(("target", "goal"), MOST.get(figure["name"], ()), strict=False))
        return {**figure, "ratio_to_inverse_dynamics": figure["median"] / inverse, **targets}

    compared = {}
    if better is not None:
        compared = {"better_baseline": better["name"], "times_faster": better["median"] / forward}
    return {
        "unit": "ns/pose",
        "robot": robot,
        "inertia_tensors": "near the given ones, such as bodies can have",
        "ratio_to": ours[0]["name"],
        "ours": [entry(figure) for figure in ours],
        "baselines": [
            {**entry(figure), "ratio_to_forward_dynamics": figure["median"] / forward} for figure in baselines
        ],
        "calls": calls,
        "empty_calls": empty,
        **compared,
        "target_times_faster": TIMES_FASTER,
        **({} if opened is None else {"loops_open_m": opened}),
        "largest_difference": dict(differences),
    }
