"""Selection of the cheapest kernel within an error budget, and the physics that prevents a cheaper one.

The cost is the number of operations, then the precision, and excludes times, so that the result for a scene
is independent of the machine. Times matter only if the budget specifies a rate.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...derive.mechanics.legs.rotor import FULL, NONE
from ...derive.mechanics.reduced_models import level_of
from ...robot.fields import need_axisymmetric
from ...robot.robot import Robot
from ..common.text_tables import Figures, aligned
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
    "joint": "corrected equations (faults 1 to 3)",
    "digits": "double precision",
}
"""Terms that a kernel may omit, as text; ``joint`` are the corrections of faults 1 to 3 of `paper`."""

_LEG_TERMS = ("off-axis", "axial", "rods", "masses")
_LEGS = ("general", "axisymmetric", "slender", "point_masses", "massless")
"""Kinds of legs; each includes one of the terms of legs less than the kind before."""

_INERTIA = frozenset({"axial", "rods", "reflected", "momentum"})
"""Terms without effect at rest."""


@dataclass(frozen=True)
class Advice:
    """Selected kernel, None if no kernel is within the budget, and the kernel with the smallest excess."""

    budget: Budget
    cost: Figures
    chosen: Figures | None
    closest: Figures

    def needed(self) -> tuple[tuple[frozenset[str], Figures], ...]:
        """Return sets of terms that no cheaper kernel may omit, each with the next cheaper kernel without."""
        if self.chosen is None:
            return ()
        rotors, every = self.budget.robot.has_rotors, self.cost["candidates"]
        kept = terms(candidate_of(self.chosen), rotors) - without_effect(self.budget.robot)
        if "rates" not in kept:
            kept -= _INERTIA
        # The last kernel that omits the same terms is the most expensive one, thus the next cheaper kernel.
        dropped = {
            kept - terms(candidate_of(entry), rotors): entry for entry in every[: every.index(self.chosen)]
        }
        return tuple(
            (left_out, entry)
            for left_out, entry in reversed(dropped.items())
            if left_out and not any(other and other < left_out for other in dropped)
        )


def advice(cost: Figures, budget: Budget) -> Advice:
    """Select the first candidate within the budget in the order of ``cost``, which sorts by cost."""
    chosen = next((entry for entry in cost["candidates"] if excess(entry, budget) <= 1.0), None)
    closest = min(cost["candidates"], key=lambda entry: excess(entry, budget))
    return Advice(budget, cost, chosen, closest)


def excess(entry: Figures, budget: Budget) -> float:
    """Return the larger ratio of error or time to the budget; at most 1 is acceptable."""
    return max(_misses(entry, budget))


def _misses(entry: Figures, budget: Budget) -> tuple[float, float]:
    """Return the ratios of error and time to the budget."""
    time = entry["one_pose_ns"] * 1e-9 * (budget.rate or 0.0)
    return worst(entry) * budget.margin / budget.tolerance, time


def terms(candidate: Candidate, rotors: bool = False) -> frozenset[str]:
    """Return the terms (keys of TERMS) that a kernel includes; ``rotors`` is True for robots with rotors."""
    level = level_of(candidate.fidelity, rotors)
    included = {
        "rates": level.moving,
        "friction": level.friction,
        "reflected": level.rotor != NONE,
        "momentum": level.rotor == FULL,
        "joint": candidate.formulation == "exact",
        "digits": candidate.precision == "double",
    }
    of_legs = _LEG_TERMS[_LEGS.index(level.legs) :]
    return frozenset(of_legs).union(name for name, kept in included.items() if kept)


def without_effect(robot: Robot) -> frozenset[str]:
    """Return the terms without effect for a robot; legs between spherical joints do not spin."""
    tensors, revolution = np.stack([robot.I_d0, robot.I_u0]), True
    try:
        need_axisymmetric(vars(robot), lambda *_: "legs")
    except ValueError:
        revolution = False
    gone = {
        "friction": not np.any([robot.C_u, robot.C_p, robot.C_s]),
        "off-axis": revolution,
        "axial": robot.base_joint == "spherical" or not tensors[..., 0, :].any(),
        "rods": not tensors[..., 1:, 1:].any(),
        "masses": not np.any([robot.m_d, robot.m_u]),
        "momentum": robot.base_joint == "spherical",
    }
    return frozenset(name for name, nothing in gone.items() if nothing)


def report(found: Advice) -> str:
    """Format the machine, the budget, a table of all candidates, and the result as one text."""
    cost = found.cost
    motions = ", ".join(
        f"{name} ({motion['poses']} poses, peak force {motion['peak_force_N']:.4g} N)"
        for name, motion in cost["motions"].items()
    )
    budget, parts = found.budget, (table(cost, found), "\n".join(answer(found)))
    limits = f"tolerance {budget.tolerance:.3g}, margin {budget.margin:g}: "
    limits += f"largest accepted error {budget.tolerance / budget.margin:.2e}"
    if budget.rate is not None:
        limits += f", {1e9 / budget.rate:.4g} ns per pose at {budget.rate:g} Hz"
    return "\n\n".join([f"{cost['robot']}: {motions}\n{limits}", *parts])


_NOTE = (
    "Errors are fractions of the peak force of their motion; each cell is the maximum over all motions.\n"
    f"Rounding errors are measured at {SAMPLED} poses of each motion, and where force and condition number "
    "are largest. Modeling errors are measured at all poses."
)
_COLUMNS = ("operations", "ns per pose", "in a batch", "modeling error", "RMS", "rounding", "total")


def table(cost: Figures, found: Advice | None = None) -> str:
    """Format all candidates, the cheapest first; with advice, the selected kernel is marked."""
    rows: list[tuple[str, ...]] = [("kernel", *_COLUMNS, "")]
    for entry in cost["candidates"]:
        errors = (worst(entry, *part) for part in (("model",), ("model_rms",), ("rounding",), ()))
        times = (f"{entry[name]:.0f}" for name in ("one_pose_ns", "batch_ns"))
        shares = (f"{error:.1e}" if error else "0" for error in errors)
        accepted = "" if found is None or excess(entry, found.budget) > 1.0 else "accepted"
        mark = "chosen" if found is not None and entry is found.chosen else accepted
        rows.append((candidate_of(entry).name, str(entry["operations"]), *times, *shares, mark))
    rows = [row[:-1] for row in rows] if found is None else rows
    return f"{aligned(rows[0], rows[1:])}\n\n{_NOTE}"


def answer(found: Advice) -> list[str]:
    """Return the result and one line for each reason that excludes a cheaper kernel."""
    if found.chosen is None:
        return [f"No kernel is within the budget; closest: {closest(found)}."]
    lines = [f"Cheapest kernel within the budget: {_cost(found.chosen)}, error {worst(found.chosen):.1e}."]
    reasons = found.needed()
    if found.chosen is found.cost["candidates"][0]:
        lines.append("No kernel is cheaper.")
    elif not reasons:
        lines.append("Cheaper kernels include the same physics, but their errors are larger.")
    for left_out, entry in reasons:
        names = " and ".join(words for term, words in TERMS.items() if term in left_out)
        lines.append(f"Required: {names}. Without: {_cost(entry)}; {_beyond(entry, found.budget)}.")
    return lines


def _cost(entry: Figures) -> str:
    return f"{candidate_of(entry).name}: {entry['operations']} operations"


def closest(found: Advice) -> str:
    """Describe the kernel that is closest to the budget, and its excess."""
    return f"{candidate_of(found.closest).name}, {_beyond(found.closest, found.budget)}"


def _beyond(entry: Figures, budget: Budget) -> str:
    """Describe the excess of a candidate over the budget, the larger one first."""
    texts = f"the error is {worst(entry):.1e}", f"a pose takes {entry['one_pose_ns']:.0f} ns"
    largest, other = sorted(zip(_misses(entry, budget), texts, strict=True), key=lambda miss: -miss[0])
    said = [largest, other] if other[0] > 1.0 else [largest]
    return "; ".join(f"{text}, {ratio:.3g} times the limit" for ratio, text in said)


def as_json(found: Advice) -> dict[str, Any]:
    """Return the budget, all data, the selected kernel, and the reasons."""
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
