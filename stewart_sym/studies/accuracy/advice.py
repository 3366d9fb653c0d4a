"""Selection of the cheapest kernel within an error budget.

The cost is the number of operations, then the precision, and excludes times, so that the result for a scene
is independent of the machine. Times matter only if the budget specifies a rate.
"""

from dataclasses import dataclass
from typing import Any

from ...backend.kernel import levels
from ..common.text_tables import Figures, aligned
from .budget import Budget
from .cost import SAMPLED, candidate_of, worst


@dataclass(frozen=True)
class Advice:
    """Selected kernel, None if no kernel is within the budget, and the best of the cheaper kernels."""

    budget: Budget
    cost: Figures
    chosen: Figures | None
    closest: Figures | None


def advice(cost: Figures, budget: Budget) -> Advice:
    """Select the first candidate within the budget in the order of ``cost``, which sorts by cost."""
    every = cost["candidates"]
    chosen = next((entry for entry in every if excess(entry, budget) <= 1.0), None)
    cheaper = every if chosen is None else every[: every.index(chosen)]
    closest = min(cheaper, key=lambda entry: excess(entry, budget), default=None)
    return Advice(budget, cost, chosen, closest)


def excess(entry: Figures, budget: Budget) -> float:
    """Return the larger ratio of error or time to the budget; at most 1 is acceptable."""
    return max(_misses(entry, budget))


def _misses(entry: Figures, budget: Budget) -> tuple[float, float]:
    """Return the ratios of error and time to the budget."""
    time = entry["one_pose_ns"] * 1e-9 * (budget.rate or 0.0)
    return worst(entry) * budget.margin / budget.tolerance, time


def report(found: Advice) -> str:
    """Format the machine, the budget, the result, and a table of all candidates as one text."""
    cost, budget = found.cost, found.budget
    motions = ", ".join(
        f"{name} ({motion['poses']} poses, peak force {motion['peak_force_N']:.4g} N)"
        for name, motion in cost["motions"].items()
    )
    limits = f"tolerance {budget.tolerance:.3g}, margin {budget.margin:g}: "
    limits += f"largest accepted error {budget.tolerance / budget.margin:.2e}"
    if budget.rate is not None:
        limits += f", {1e9 / budget.rate:.4g} ns per pose at {budget.rate:g} Hz"
    return "\n\n".join([f"{cost['robot']}: {motions}\n{limits}", answer(found), table(cost, found)])


_NOTE = (
    "Errors are fractions of the peak force of their motion; each cell is the maximum over all motions.\n"
    f"Rounding errors are measured at {SAMPLED} poses of each motion, and where force and condition number "
    "are largest. Modeling errors are measured at all poses."
)
_COLUMNS = ("operations", "ns per pose", "in a batch", "modeling error", "RMS", "rounding", "total")


def table(cost: Figures, found: Advice | None = None) -> str:
    """Format all candidates, the cheapest first; with advice, the acceptable kernels are marked."""
    rows = []
    for entry in cost["candidates"]:
        errors = (worst(entry, *part) for part in (("model",), ("model_rms",), ("rounding",), ()))
        times = (f"{entry[name]:.0f}" for name in ("one_pose_ns", "batch_ns"))
        shares = (f"{error:.1e}" if error else "0" for error in errors)
        mark = ""
        if found is not None and excess(entry, found.budget) <= 1.0:
            mark = "chosen" if entry is found.chosen else "accepted"
        rows.append((candidate_of(entry).name, str(entry["operations"]), *times, *shares, mark))
    return f"{aligned(('kernel', *_COLUMNS, ''), rows)}\n\n{_NOTE}"


def answer(found: Advice) -> str:
    """Return the result and the best of the cheaper kernels, with the physics of both."""
    closest = "none" if found.closest is None else _beyond(found, found.closest)
    if found.chosen is None:
        return f"No kernel is within the budget; closest: {closest}"
    chosen = f"{_named(found, found.chosen)}, error {worst(found.chosen):.1e}"
    return f"Cheapest kernel within the budget: {chosen}\nBest of the cheaper kernels: {closest}"


def _named(found: Advice, entry: Figures) -> str:
    physics = levels(found.budget.robot)[entry["fidelity"]]["meaning"]
    physics = "as printed" if entry["formulation"] == "paper" else physics
    return f"{candidate_of(entry).name} ({physics}): {entry['operations']} operations"


def _beyond(found: Advice, entry: Figures) -> str:
    """Describe the excess of a candidate over the budget, the larger one first."""
    texts = f"error {worst(entry):.1e}", f"{entry['one_pose_ns']:.0f} ns per pose"
    misses = sorted(zip(_misses(entry, found.budget), texts, strict=True), reverse=True)
    parts = [f"{text}, {ratio:.3g} times the limit" for ratio, text in misses if ratio > 1.0]
    return "; ".join([_named(found, entry), *parts])


def as_json(found: Advice) -> dict[str, Any]:
    """Return the budget, all data, and the selected kernel."""
    kernels = {"chosen": found.chosen, "closest": found.closest}
    return {
        **found.cost,
        "tolerance": found.budget.tolerance,
        "margin": found.budget.margin,
        "rate_Hz": found.budget.rate,
        **{name: None if entry is None else candidate_of(entry)._asdict() for name, entry in kernels.items()},
    }
