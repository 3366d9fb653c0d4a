"""Advice: the cheapest kernel that keeps a budget, and what physics forbids a cheaper one.

Cost is operations, then precision, and no times, so that the same scene gets the same answer on every
machine; times count only where the budget names a rate.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...derive.mechanics.legs.rotor import FULL, NONE
from ...derive.mechanics.reduced_models import DRIVE_FIDELITIES, FIDELITIES, Fidelity, level_of
from ...robot.fields import need_axisymmetric
from ...robot.robot import Robot
from ..common.output import Figures, aligned
from .budget import Budget
from .cost import SAMPLED, Candidate, candidate_of, worst

TERMS: Mapping[str, str] = {
    "friction": "joint friction",
    "off-axis": "centers of mass off the legs' axes and unequal transverse inertias",
    "axial": "the legs' inertia about their own axes",
    "rods": "the legs' inertia as rods",
    "masses": "the legs' masses",
    "reflected": "the rotors' reflected masses",
    "momentum": "the rotors' angular momenta",
    "rates": "velocities and accelerations",
    "joint": "the right equations of joint and inertia",
    "digits": "double precision",
}
"""What a kernel may leave out, in words; ``joint`` is what `paper` has not, faults 1 to 3."""

_LEGS: Mapping[str, frozenset[str]] = {
    "general": frozenset({"off-axis", "axial", "rods", "masses"}),
    "axisymmetric": frozenset({"axial", "rods", "masses"}),
    "slender": frozenset({"rods", "masses"}),
    "point_masses": frozenset({"masses"}),
    "massless": frozenset(),
}
"""Terms that each kind of leg has."""


def check_legs(levels: Mapping[str, Fidelity]) -> None:
    """Raise ValueError, of one line, for a level whose kind of leg has no terms."""
    for name, level in levels.items():
        if level.legs not in _LEGS:
            expected = f"the terms of {level.legs!r}, legs of {name}"
            raise ValueError(f"_LEGS in advice.py: expected {expected}, got none")


check_legs(FIDELITIES | DRIVE_FIDELITIES)

_INERTIA = frozenset({"axial", "rods", "reflected", "momentum"})
"""Terms that have no effect at rest."""


@dataclass(frozen=True)
class Advice:
    """What to take. chosen: None where nothing keeps the budget; closest: what comes nearest to it then."""

    budget: Budget
    cost: Figures
    chosen: Figures | None
    closest: Figures

    def needed(self) -> tuple[tuple[frozenset[str], Figures], ...]:
        """The terms of the choice that no cheaper kernel may leave out, one by one or a few together.

        With each, the next cheaper kernel that leaves out these and no more than it has to.
        """
        if self.chosen is None:
            return ()
        rotors, every = self.budget.robot.has_rotors, self.cost["candidates"]
        kept = terms(candidate_of(self.chosen), rotors) - without_effect(self.budget.robot)
        if "rates" not in kept:
            kept -= _INERTIA
        # Of those without the same terms the last is the dearest, the next cheaper one.
        dropped = {
            kept - terms(candidate_of(entry), rotors): entry for entry in every[: every.index(self.chosen)]
        }
        return tuple(
            (left_out, entry)
            for left_out, entry in reversed(dropped.items())
            if left_out and not any(other and other < left_out for other in dropped)
        )


def advice(cost: Figures, budget: Budget) -> Advice:
    """Choose the first good enough candidate of those that ``cost`` lists by cost."""
    chosen = next((entry for entry in cost["candidates"] if excess(entry, budget) <= 1.0), None)
    closest = min(cost["candidates"], key=lambda entry: excess(entry, budget))
    return Advice(budget, cost, chosen, closest)


def excess(entry: Figures, budget: Budget) -> float:
    """How many times a candidate exceeds the budget, in error or in time; good enough up to 1."""
    return max(_misses(entry, budget))


def _misses(entry: Figures, budget: Budget) -> tuple[float, float]:
    """Error and time over what is allowed; no time is too long where the budget names no rate."""
    error = worst(entry) * budget.margin / budget.tolerance
    return error, 0.0 if budget.rate is None else entry["one_pose_ns"] * 1e-9 * budget.rate


def terms(candidate: Candidate, rotors: bool = False) -> frozenset[str]:
    """The terms, keys of TERMS, that a kernel has; rotors: of a robot whose legs have them."""
    level = level_of(candidate.fidelity, rotors)
    kept = set(_LEGS[level.legs])
    if level.moving:
        kept.add("rates")
    if level.friction:
        kept.add("friction")
    if level.rotor != NONE:
        kept.add("reflected")
    if level.rotor == FULL:
        kept.add("momentum")
    if candidate.formulation == "exact":
        kept.add("joint")
    if candidate.precision == "double":
        kept.add("digits")
    return frozenset(kept)


def without_effect(robot: Robot) -> frozenset[str]:
    """The terms of which a robot has nothing; between spherical joints legs do not spin."""
    tensors = np.stack([robot.I_d0, robot.I_u0])
    gone = {
        "friction": not np.any([robot.C_u, robot.C_p, robot.C_s]),
        "off-axis": _of_revolution(robot),
        "axial": robot.base_joint == "spherical" or not tensors[..., 0, :].any(),
        "rods": not tensors[..., 1:, 1:].any(),
        "masses": not np.any([robot.m_d, robot.m_u]),
        "momentum": robot.base_joint == "spherical",
    }
    return frozenset(name for name, nothing in gone.items() if nothing)


def _of_revolution(robot: Robot) -> bool:
    try:
        need_axisymmetric(vars(robot), lambda *_: "legs")
    except ValueError:
        return False
    return True


def report(found: Advice) -> str:
    """Machine, budget, a table of all candidates and the answer, as one text."""
    cost = found.cost
    motions = ", ".join(
        f"{name} ({motion['poses']} poses, peak force {motion['peak_force_N']:.4g} N)"
        for name, motion in cost["motions"].items()
    )
    head = f"{cost['robot']}: {motions}\n{_limits(found.budget)}"
    return "\n\n".join([head, table(cost, found), "\n".join(answer(found))])


_WHERE = (
    f"Rounding is measured at {SAMPLED} poses spread over each motion and where force and condition "
    "number are largest, the model error at all poses."
)

_COLUMNS = (
    *("kernel", "operations", "ns per pose", "in a batch", "bytes"),
    *("model error", "RMS", "rounding", "total"),
)


def table(cost: Figures, found: Advice | None = None) -> str:
    """All candidates, the cheapest first; with advice, the choice is marked."""
    header = [*_COLUMNS, *([] if found is None else [""])]
    rows = [
        (
            candidate_of(entry).name,
            str(entry["operations"]),
            f"{entry['one_pose_ns']:.0f}",
            f"{entry['batch_ns']:.0f}",
            "" if entry["text_bytes"] is None else str(entry["text_bytes"]),
            *(_share(worst(entry, *part)) for part in (("model",), ("model_rms",), ("rounding",), ())),
            *([] if found is None else [_mark(entry, found)]),
        )
        for entry in cost["candidates"]
    ]
    note = "Errors are shares of the peak force of their motion, the worst motion counts."
    return f"{aligned(header, rows)}\n\n{note}\n{_WHERE}"


def _share(error: float) -> str:
    return f"{error:.1e}" if error else "0"


def _mark(entry: Figures, found: Advice) -> str:
    if entry is found.chosen:
        return "chosen"
    return "good" if excess(entry, found.budget) <= 1.0 else ""


def _limits(budget: Budget) -> str:
    rate = "" if budget.rate is None else f", {1e9 / budget.rate:.4g} ns per pose at {budget.rate:g} Hz"
    return (
        f"tolerance {budget.tolerance:.3g}, margin {budget.margin:g}: "
        f"good enough up to an error of {budget.tolerance / budget.margin:.2e}{rate}"
    )


def answer(found: Advice) -> list[str]:
    """The choice, and one line for each reason why it is none of the cheaper ones."""
    if found.chosen is None:
        return [f"Nothing keeps the budget; closest: {closest(found)}."]
    lines = [f"Cheapest that is good enough: {_cost(found.chosen)}, error {worst(found.chosen):.1e}."]
    reasons = found.needed()
    if found.chosen is found.cost["candidates"][0]:
        lines.append("Nothing is cheaper.")
    elif not reasons:
        lines.append("Cheaper ones leave nothing out that it has, yet err more.")
    for left_out, entry in reasons:
        names = " and ".join(words for term, words in TERMS.items() if term in left_out)
        lines.append(f"Forced by {names}: without ({_cost(entry)}) {_beyond(entry, found.budget)}.")
    return lines


def _cost(entry: Figures) -> str:
    return f"{candidate_of(entry).name}: {entry['operations']} operations"


def closest(found: Advice) -> str:
    """What comes nearest to the budget, and by how much it is missed."""
    entry = found.closest
    return f"{candidate_of(entry).name}, {_beyond(entry, found.budget)}"


def _beyond(entry: Figures, budget: Budget) -> str:
    """How a candidate misses the budget, the larger miss first."""
    error, time = _misses(entry, budget)
    said = [
        (error, f"the error is {worst(entry):.1e}, {error:.3g} times what is allowed"),
        (time, f"a pose takes {entry['one_pose_ns']:.0f} ns, {time:.3g} times what is allowed"),
    ]
    largest, *others = sorted(said, key=lambda miss: -miss[0])
    return "; ".join(text for _, text in [largest, *(miss for miss in others if miss[0] > 1.0)])


def as_json(found: Advice) -> dict[str, Any]:
    """The budget, all figures, the choice and the reasons for it."""
    budget, chosen = found.budget, found.chosen
    return {
        **found.cost,
        "tolerance": budget.tolerance,
        "margin": budget.margin,
        "rate_Hz": budget.rate,
        "chosen": None if chosen is None else candidate_of(chosen)._asdict(),
        "closest": candidate_of(found.closest)._asdict(),
        "needed": [
            {"terms": sorted(left_out), "without": candidate_of(entry)._asdict(), "error": worst(entry)}
            for left_out, entry in found.needed()
        ],
    }
