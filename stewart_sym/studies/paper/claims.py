"""Claims of the paper, with its numbers, compared with the results; each verdict has an explicit rule."""

from collections.abc import Callable

import numpy as np

from ...io.array_types import Array
from ...motion.straight_line import PAPER_PATHS
from ..common.output import Figures
from .reproduce import LIGHT_PLATFORM, PathRun, Reproduction

HOLDS, PARTLY, FAILS = "holds", "partly", "does not hold"

NEAR_ZERO = 0.1
"""Fraction of the largest |F| of a leg on the path below which its dynamic fraction is not counted."""

PAPER_FLOPS = {"leg": 694, "platform": 273, "final": 452, "total": 4889}
SERIAL_ARM_FLOPS = 1454
"""Operations of the Newton-Euler inverse dynamics of a serial arm with six joints (section 4.5)."""

Check = Callable[[Reproduction, str], tuple[object, ...]]
"""Function that returns the result of a formulation as text, and True if the claim is correct, or partly."""
_CLAIMS: list[tuple[Figures, Check]] = []


def _claim(where: str, says: str, rule: str) -> Callable[[Check], Check]:
    """Return a decorator that adds a check to the claims, in the order of the paper."""

    def added(check: Check) -> Check:
        _CLAIMS.append(({"where": where, "says": says, "rule": rule}, check))
        return check

    return added


def claims(found: Reproduction) -> list[Figures]:
    """Return every claim, in the order of the paper, with its result and verdict by formulation."""
    return [
        claim | {form: _measured(*check(found, form)) for form in ("paper", "exact")}
        for claim, check in _CLAIMS
    ]


def _measured(text: object, holds: object, partly: object = False) -> Figures:
    return {"text": str(text), "verdict": HOLDS if holds else PARTLY if partly else FAILS}


def counted_fractions(run: PathRun) -> Array:
    """Return |F_d / F|, 1-D, of all samples with |F| >= NEAR_ZERO of the largest |F| of the leg."""
    size = np.abs(run.F)
    return np.asarray(np.abs(run.fraction)[size >= NEAR_ZERO * size.max(axis=0)])


def crossing_legs(run: PathRun) -> list[int]:
    """List the legs, from 1, whose total force changes its sign on the path."""
    return [i + 1 for i in range(6) if np.any(np.diff(np.sign(run.F[:, i])) != 0)]


def rank_correlation(x: Array, y: Array) -> float:
    """Compute Spearman's rank correlation, -1 to 1, without ties."""
    return float(np.asarray(np.corrcoef(np.argsort(np.argsort([x, y], axis=-1), axis=-1)))[0, 1])


def largest(run: PathRun) -> float:
    """Return the largest |F| of all legs and samples (N)."""
    return float(np.max(np.abs(run.F)))


def _worst_time(run: PathRun) -> float:
    return float(run.time[np.max(np.abs(run.F), axis=-1).argmax()])


def _short(number: float) -> str:
    """Format two digits and a short exponent: 9.6e5."""
    digits, exponent = f"{number:.1e}".split("e")
    return f"{digits}e{int(exponent)}"


@_claim(
    "4.5",
    "4889 floating point operations a time-step without friction, only 3.36 times those of a serial arm",
    "kernel has at most as many",
)
def _cost(found: Reproduction, form: str) -> tuple[object, ...]:
    kernels = {row["formulation"]: row for row in found.operations if not row["friction"]}
    total = sum(kernels[form]["total"])
    text = f"{total}, {total / SERIAL_ARM_FLOPS:.2f} times the arm's {SERIAL_ARM_FLOPS}"
    return text, total <= PAPER_FLOPS["total"]


@_claim(
    "5.1, Fig. 4",
    "Path I: forces of the same order as the weight of platform and payload",
    "median above 0.1, largest below 10 weights",
)
def _size(found: Reproduction, form: str) -> tuple[object, ...]:
    run = found.runs["I", form]
    weight = found.robot.M * float(np.linalg.norm(found.robot.g))
    median, top = float(np.median(np.abs(run.F))) / weight, largest(run) / weight
    text = f"weight {weight:.0f} N; |F| median {median:.2f}, largest {top:.2f} weights"
    return text, median > 0.1 and top < 10


@_claim("5.1, Fig. 4", "Path I: forces vary smoothly", "no step above 5% of the largest |F|")
def _smooth(found: Reproduction, form: str) -> tuple[object, ...]:
    run = found.runs["I", form]
    step = float(np.max(np.abs(np.diff(run.F, axis=0)))) / largest(run)
    return f"largest change in one step of 0.1 s: {step:.1%} of largest |F|", step < 0.05


@_claim("5.1, Fig. 5", "Path I: quite well-conditioned", "condition number below 100")
def _conditioned(found: Reproduction, form: str) -> tuple[object, ...]:
    k = found.runs["I", form].condition
    return f"{k.min():.2f} to {k.max():.2f}", k.max() < 100


@_claim("5.1, Fig. 6", "Path I: dynamic fraction around 20% is quite common", "median 15 to 25%")
def _common(found: Reproduction, form: str) -> tuple[object, ...]:
    fractions = counted_fractions(found.runs["I", form])
    low, median, high = np.quantile(fractions, [0.25, 0.5, 0.75])
    return f"median {median:.1%}, middle half {low:.0%} to {high:.0%}", 0.15 < median < 0.25


@_claim("5.1, Fig. 6", "Path I: its maximum may even go up to 40%", "largest 35 to 45%")
def _maximum(found: Reproduction, form: str) -> tuple[object, ...]:
    run = found.runs["I", form]
    keep = [leg for leg in range(6) if leg + 1 not in crossing_legs(run)]
    peaks = np.abs(run.fraction[:, keep]).max(axis=0)
    top = float(peaks.max())
    text = f"{top:.1%} in leg {keep[int(peaks.argmax())] + 1}; only legs whose F keeps its sign"
    return text, 0.35 < top < 0.45


@_claim("5.1, Fig. 6", "Path I: it jumps in legs 5 and 6, as F crosses zero", "exactly these two legs")
def _crossing(found: Reproduction, form: str) -> tuple[object, ...]:
    legs = crossing_legs(found.runs["I", form])
    named = " and ".join(map(str, legs)) or "none"
    return f"F crosses zero in legs {named}", legs == [5, 6], set(legs) & {5, 6}


@_claim(
    "5.1",
    "platform mass of the order of a leg's: dynamic fraction often above 60%",
    "in more than half of the samples (partly: a quarter)",
)
def _light(found: Reproduction, form: str) -> tuple[object, ...]:
    fractions = counted_fractions(found.light[form])
    share = float(np.mean(fractions > 0.6))
    text = f"Path I, platform {LIGHT_PLATFORM:g} kg: above 60% in {share:.0%} of samples; "
    return text + f"median {np.median(fractions):.0%}", share > 0.5, share > 0.25


@_claim("5.1, Fig. 7", "Path II: significant rise in the bounds of the forces", "20% more (partly: more)")
def _faster_forces(found: Reproduction, form: str) -> tuple[object, ...]:
    slow, fast = (largest(found.runs[name, form]) for name in ("I", "II"))
    return f"largest |F| {slow:.0f} N to {fast:.0f} N", fast > 1.2 * slow, fast > slow


@_claim(
    "5.1, Fig. 8",
    "Path II: significant rise in the dynamic fractions",
    "median and upper tenth rise by a tenth (partly: one of them)",
)
def _faster_fractions(found: Reproduction, form: str) -> tuple[object, ...]:
    slow, fast = (np.quantile(counted_fractions(found.runs[name, form]), [0.5, 0.9]) for name in ("I", "II"))
    text = f"median {slow[0]:.1%} to {fast[0]:.1%}, upper tenth {slow[1]:.1%} to {fast[1]:.1%}"
    return text, np.all(fast > 1.1 * slow), np.any(fast > 1.1 * slow)


@_claim(
    "5.1, Fig. 7",
    "Path II: steep changes of force come from steep changes of acceleration",
    "every such step exceeds all others (partly: the steepest does)",
)
def _steep(found: Reproduction, form: str) -> tuple[object, ...]:
    run = found.runs["II", form]
    step = np.max(np.abs(np.diff(run.F, axis=0)), axis=-1)
    jumps = PAPER_PATHS["II"].path.breakpoints()[1:-1]
    # A sample at a jump has the value after the jump, so the step that ends there contains the jump.
    at = np.unique(np.searchsorted(run.time, jumps - 1e-9) - 1)
    least, elsewhere = float(step[at].min()), float(np.delete(step, at).max())
    text = f"change in a step of 0.01 s: {least:.0f} to {step.max():.0f} N in the {len(at)} steps where an "
    text += f"acceleration jumps, at most {elsewhere:.0f} N in others"
    return text, least > elsewhere, step[at].max() > elsewhere


@_claim("5.2, Fig. 9", "Path III: forces of the order of 1e5 N", "1e5 to 1e6 N on the paper's time grid")
def _singular(found: Reproduction, form: str) -> tuple[object, ...]:
    run, force = found.runs["III", form], largest(found.runs["III", form])
    text = f"{_short(force)} N at {_worst_time(run):.1f} s; H is singular at {found.singular_time:.3f} s"
    return text, 1e5 <= force < 1e6, force >= 1e5


@_claim(
    "5.2, Fig. 10",
    "Path III: the condition number rises sharply precisely there",
    "at the same time of the grid",
)
def _precisely(found: Reproduction, form: str) -> tuple[object, ...]:
    run = found.runs["III", form]
    peak, worst = float(run.time[run.condition.argmax()]), _worst_time(run)
    text = f"condition number {_short(run.condition.max())} at {peak:.1f} s, forces largest at {worst:.1f} s"
    return text, peak == worst


@_claim(
    "5.2",
    "condition number of the order of 1e2 or 1e3: forces of the order of 1e4 N or more",
    "nine tenths of samples (partly: half)",
)
def _near_singular(found: Reproduction, form: str) -> tuple[object, ...]:
    run = found.runs["III", form]
    near = (run.condition >= 1e2) & (run.condition < 1e4)
    top = np.max(np.abs(run.F), axis=-1)[near]
    share = float(np.mean(top >= 1e4))
    text = f"Path III, condition number {run.condition.min():.0f} to 1e4: largest |F| "
    text += f"from {_short(top.min())} N, 1e4 N or more in {share:.0%} of samples"
    return text, share > 0.9, share > 0.5


@_claim(
    "6",
    "leg inertia generally contributes 20 to 50% of the forces",
    "more than half of the samples on every path (partly: a quarter on one)",
)
def _generally(found: Reproduction, form: str) -> tuple[object, ...]:
    fractions = (counted_fractions(found.runs[name, form]) for name in PAPER_PATHS)
    shares = [float(np.mean((each >= 0.2) & (each <= 0.5))) for each in fractions]
    parts = ", ".join(f"{name} {share:.0%}" for name, share in zip(PAPER_PATHS, shares, strict=True))
    return f"samples within 20 to 50%: {parts}", min(shares) > 0.5, max(shares) > 0.25


@_claim(
    "6",
    "that fraction increases when the speed is high and the payload is less",
    "median rises in both cases (partly: in one)",
)
def _more(found: Reproduction, form: str) -> tuple[object, ...]:
    runs = (found.runs["I", form], found.runs["II", form], found.light[form])
    slow, fast, light = (float(np.median(counted_fractions(run))) for run in runs)
    text = f"median {slow:.1%}; ten times as fast {fast:.1%}; platform {LIGHT_PLATFORM:g} kg {light:.1%}"
    return text, fast > slow and light > slow, fast > slow or light > slow


@_claim(
    "6",
    "the higher the condition number, the higher the forces",
    "rank correlation above 0.5 on every path (partly: on one)",
)
def _relation(found: Reproduction, form: str) -> tuple[object, ...]:
    runs = {name: found.runs[name, form] for name in PAPER_PATHS}
    ranks = {name: rank_correlation(run.condition, np.abs(run.F).max(axis=-1)) for name, run in runs.items()}
    text = "rank correlation of condition number and largest |F|: "
    text += ", ".join(f"{name} {value:+.2f}" for name, value in ranks.items())
    strong = [value > 0.5 for value in ranks.values()]
    return text, all(strong), any(strong)
