"""Advice: the cheapest kernel that keeps a budget, and what physics forbids a cheaper one.

Cost is operations, then precision, and no times, so that the same scene gets the same answer on every
machine; times count only where the budget names a rate.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...derive.mechanics.legs.rotor import FULL, NONE
from ...derive.mechanics.reduced_models import DRIVE_FIDELITIES, FIDELITIES, Fidelity, level_of
from ..common.output import aligned
from .budget import Budget
from .cost import SAMPLED, Candidate, CostAccuracy, Entry

TERMS: Mapping[str, str] = {
    "friction": "joint friction",
    "off-axis": "centres of mass off the legs' axes and unequal transverse inertias",
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
    cost: CostAccuracy
    chosen: Entry | None
    closest: Entry

    def needed(self) -> tuple[tuple[frozenset[str], Entry], ...]:
        """The terms of the choice that no cheaper kernel may leave out, one by one or a few together.

        With each, the next cheaper kernel that leaves out these and no more than it has to.
        """
        if self.chosen is None:
            return ()
        kept = terms(self.chosen.candidate, self.cost.rotors)
        if "rates" not in kept:
            kept -= _INERTIA
        cheaper = self.cost.entries[: self.cost.entries.index(self.chosen)]
        dropped: dict[frozenset[str], Entry] = {}
        for entry in cheaper:
            # The last is the dearest, the next cheaper one.
            dropped[kept - terms(entry.candidate, self.cost.rotors)] = entry
        return tuple(
            (left_out, entry)
            for left_out, entry in reversed(dropped.items())
            if left_out and not any(other and other < left_out for other in dropped)
        )


def advice(cost: CostAccuracy, budget: Budget) -> Advice:
    """Choose the first good enough candidate of those that ``cost`` lists by cost."""
    chosen = next((entry for entry in cost.entries if excess(entry, budget) <= 1.0), None)
    closest = min(cost.entries, key=lambda entry: excess(entry, budget))
    return Advice(budget, cost, chosen, closest)


def excess(entry: Entry, budget: Budget) -> float:
    """How many times a candidate exceeds the budget, in error or in time; good enough up to 1."""
    return max(_misses(entry, budget))


def _misses(entry: Entry, budget: Budget) -> tuple[float, float]:
    """Error and time over what is allowed; no time is too long where the budget names no rate."""
    error = entry.total * budget.margin / budget.tolerance
    return error, 0.0 if budget.rate is None else entry.ns * 1e-9 * budget.rate


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


def report(found: Advice) -> str:
    """Machine, budget, a table of all candidates and the answer, as one text."""
    cost = found.cost
    motions = ", ".join(
        f"{name} ({cost.poses[name]} poses, peak force {peak:.4g} N)" for name, peak in cost.peaks.items()
    )
    head = f"{cost.robot}: {motions}\n{_limits(found.budget)}"
    return "\n\n".join([head, table(cost, found), "\n".join(answer(found))])


_WHERE = (
    f"Rounding is measured at {SAMPLED} poses spread over each motion and where force and condition "
    "number are largest, the model error at all poses."
)

_COLUMNS = (
    *("kernel", "operations", "ns per pose", "in a batch", "bytes"),
    *("model error", "RMS", "rounding", "total"),
)


def table(cost: CostAccuracy, found: Advice | None = None) -> str:
    """All candidates, the cheapest first; with advice, the choice is marked."""
    header = [*_COLUMNS, *([] if found is None else [""])]
    rows = [
        (
            entry.candidate.name,
            str(entry.operations),
            f"{entry.ns:.0f}",
            f"{entry.batch_ns:.0f}",
            "" if entry.text is None else str(entry.text),
            *map(_share, (entry.model, entry.model_rms, entry.rounding, entry.total)),
            *([] if found is None else [_mark(entry, found)]),
        )
        for entry in cost.entries
    ]
    note = "Errors are shares of the peak force of their motion, the worst motion counts."
    return f"{aligned(header, rows)}\n\n{note}\n{_WHERE}"


def _share(error: float) -> str:
    return f"{error:.1e}" if error else "0"


def _mark(entry: Entry, found: Advice) -> str:
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
    lines = [
        f"Cheapest that is good enough: {found.chosen.candidate.name}: {found.chosen.operations} operations, "
        f"error {found.chosen.total:.1e}."
    ]
    reasons = found.needed()
    if found.chosen is found.cost.entries[0]:
        lines.append("Nothing is cheaper.")
    elif not reasons:
        lines.append("Cheaper ones leave nothing out that it has, yet err more.")
    for left_out, entry in reasons:
        names = " and ".join(words for term, words in TERMS.items() if term in left_out)
        without = f"{entry.candidate.name}: {entry.operations} operations"
        lines.append(f"Forced by {names}: without ({without}) {_beyond(entry, found.budget)}.")
    return lines


def closest(found: Advice) -> str:
    """What comes nearest to the budget, and by how much it is missed."""
    entry = found.closest
    return f"{entry.candidate.name}, {_beyond(entry, found.budget)}"


def _beyond(entry: Entry, budget: Budget) -> str:
    """How a candidate misses the budget, the larger miss first."""
    error, time = _misses(entry, budget)
    said = [
        (error, f"the error is {entry.total:.1e}, {error:.3g} times what is allowed"),
        (time, f"a pose takes {entry.ns:.0f} ns, {time:.3g} times what is allowed"),
    ]
    largest, *others = sorted(said, key=lambda miss: -miss[0])
    return "; ".join(text for _, text in [largest, *(miss for miss in others if miss[0] > 1.0)])


def as_json(found: Advice) -> dict[str, Any]:
    """The budget, all figures, the choice and the reasons for it."""
    budget, chosen = found.budget, found.chosen
    return {
        **found.cost.as_json(),
        "tolerance": budget.tolerance,
        "margin": budget.margin,
        "rate_Hz": budget.rate,
        "chosen": None if chosen is None else vars(chosen.candidate),
        "closest": vars(found.closest.candidate),
        "needed": [
            {"terms": sorted(left_out), "without": vars(entry.candidate), "error": entry.total}
            for left_out, entry in found.needed()
        ],
    }
