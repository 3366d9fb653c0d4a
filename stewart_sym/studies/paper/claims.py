"""Claims of the paper, with its numbers, compared with the results; each verdict has an explicit rule."""

from collections.abc import Iterator

import numpy as np
from scipy.stats import spearmanr

from ...io.array_types import Array
from ...motion.straight_line import PAPER_PATHS
from ..common.text_tables import Figures
from .reproduce import LIGHT_PLATFORM, PathRun, Reproduction

HOLDS, PARTLY, FAILS = "holds", "partly", "does not hold"

NEAR_ZERO = 0.1
"""Fraction of the largest |F| of a leg on the path below which its dynamic fraction is not counted."""

PAPER_FLOPS = {"leg": 694, "platform": 273, "final": 452, "total": 4889}
SERIAL_ARM_FLOPS = 1454
"""Operations of the Newton-Euler inverse dynamics of a serial arm with six joints (section 4.5)."""

Claims = Iterator[tuple[object, ...]]
"""Section, claim, rule, result as text, and True if the claim is correct, or partly correct."""


def claims(found: Reproduction) -> list[Figures]:
    """Return every claim, in the order of the paper, with its result and verdict by formulation."""
    parts = (_cost, _path_I, _path_II, _path_III, _conclusions)
    paper, exact = ([row for part in parts for row in part(found, form)] for form in ("paper", "exact"))
    return [
        {"where": one[0], "says": one[1], "rule": one[2], "paper": _result(*one), "exact": _result(*other)}
        for one, other in zip(paper, exact, strict=True)
    ]


def _result(
    where: object, says: object, rule: object, text: object, holds: object, partly: object = False
) -> Figures:
    return {"text": text, "verdict": HOLDS if holds else PARTLY if partly else FAILS}


def counted_fractions(run: PathRun) -> Array:
    """Return |F_d / F|, 1-D, of all samples with |F| >= NEAR_ZERO of the largest |F| of the leg."""
    size = np.abs(run.F)
    return np.asarray(np.abs(run.fraction)[size >= NEAR_ZERO * size.max(axis=0)])


def _cost(found: Reproduction, form: str) -> Claims:
    says = (
        "4889 floating point operations a time-step without friction, only 3.36 times those of a serial arm"
    )
    kernels = {row["formulation"]: row for row in found.operations if not row["friction"]}
    total = sum(kernels[form]["total"])
    text = f"{total}, {total / SERIAL_ARM_FLOPS:.2f} times the arm's {SERIAL_ARM_FLOPS}"
    yield "4.5", says, "kernel has at most as many", text, total <= PAPER_FLOPS["total"]


def _path_I(found: Reproduction, form: str) -> Claims:
    run = found.runs["I", form]
    force, weight = np.abs(run.F), found.robot.M * float(np.linalg.norm(found.robot.g))
    median, top = np.median(force) / weight, force.max() / weight
    says = "Path I: forces of the same order as the weight of platform and payload"
    text = f"weight {weight:.0f} N; |F| median {median:.2f}, largest {top:.2f} weights"
    rule = "median above 0.1, largest below 10 weights"
    yield "5.1, Fig. 4", says, rule, text, median > 0.1 and top < 10

    step = np.max(np.abs(np.diff(run.F, axis=0))) / force.max()
    text = f"largest change in one step of 0.1 s: {step:.1%} of largest |F|"
    rule = "no step above 5% of the largest |F|"
    yield "5.1, Fig. 4", "Path I: forces vary smoothly", rule, text, step < 0.05

    low, high = run.condition.min(), run.condition.max()
    says, rule = "Path I: quite well-conditioned", "condition number below 100"
    yield "5.1, Fig. 5", says, rule, f"{low:.2f} to {high:.2f}", high < 100

    low, median, high = np.quantile(counted_fractions(run), [0.25, 0.5, 0.75])
    says = "Path I: dynamic fraction around 20% is quite common"
    text = f"median {median:.1%}, middle half {low:.0%} to {high:.0%}"
    yield "5.1, Fig. 6", says, "median 15 to 25%", text, 0.15 < median < 0.25

    crosses = np.any(np.diff(np.sign(run.F), axis=0) != 0, axis=0)
    peaks = np.where(crosses, 0.0, np.abs(run.fraction).max(axis=0))
    text = f"{peaks.max():.1%} in leg {peaks.argmax() + 1}; only legs whose F keeps its sign"
    says = "Path I: its maximum may even go up to 40%"
    yield "5.1, Fig. 6", says, "largest 35 to 45%", text, 0.35 < peaks.max() < 0.45

    legs = (np.flatnonzero(crosses) + 1).tolist()
    text = f"F crosses zero in legs {' and '.join(map(str, legs)) or 'none'}"
    says = "Path I: it jumps in legs 5 and 6, as F crosses zero"
    yield "5.1, Fig. 6", says, "exactly these two legs", text, legs == [5, 6], set(legs) & {5, 6}

    fractions = counted_fractions(found.light[form])
    share = np.mean(fractions > 0.6)
    says = "platform mass of the order of a leg's: dynamic fraction often above 60%"
    text = f"Path I, platform {LIGHT_PLATFORM:g} kg: above 60% in {share:.0%} of samples; "
    text += f"median {np.median(fractions):.0%}"
    rule = "in more than half of the samples (partly: a quarter)"
    yield "5.1", says, rule, text, share > 0.5, share > 0.25


def _path_II(found: Reproduction, form: str) -> Claims:
    run, slower = found.runs["II", form], found.runs["I", form]
    slow, fast = (np.max(np.abs(each.F)) for each in (slower, run))
    says = "Path II: significant rise in the bounds of the forces"
    text = f"largest |F| {slow:.0f} N to {fast:.0f} N"
    yield "5.1, Fig. 7", says, "20% more (partly: more)", text, fast > 1.2 * slow, fast > slow

    before, after = (np.quantile(counted_fractions(each), [0.5, 0.9]) for each in (slower, run))
    says = "Path II: significant rise in the dynamic fractions"
    text = f"median {before[0]:.1%} to {after[0]:.1%}, upper tenth {before[1]:.1%} to {after[1]:.1%}"
    rule, more = "median and upper tenth rise by a tenth (partly: one of them)", after > 1.1 * before
    yield "5.1, Fig. 8", says, rule, text, more.all(), more.any()

    step = np.max(np.abs(np.diff(run.F, axis=0)), axis=-1)
    jumps = PAPER_PATHS["II"].path.breakpoints()[1:-1]
    # A sample at a jump has the value after the jump, so the step that ends there contains the jump.
    at = np.unique(np.searchsorted(run.time, jumps - 1e-9) - 1)
    least, elsewhere = step[at].min(), np.delete(step, at).max()
    says = "Path II: steep changes of force come from steep changes of acceleration"
    text = f"change in a step of 0.01 s: {least:.0f} to {step.max():.0f} N in the {len(at)} steps where an "
    text += f"acceleration jumps, at most {elsewhere:.0f} N in others"
    rule = "every such step exceeds all others (partly: the steepest does)"
    yield "5.1, Fig. 7", says, rule, text, least > elsewhere, step[at].max() > elsewhere


def _path_III(found: Reproduction, form: str) -> Claims:
    run = found.runs["III", form]
    force = np.max(np.abs(run.F), axis=-1)
    top, worst = force.max(), run.time[force.argmax()]
    says, rule = "Path III: forces of the order of 1e5 N", "1e5 to 1e6 N on the paper's time grid"
    text = f"{top:.1e} N at {worst:.1f} s; H is singular at {found.singular_time:.3f} s"
    yield "5.2, Fig. 9", says, rule, text, 1e5 <= top < 1e6, top >= 1e5

    peak = run.time[run.condition.argmax()]
    says = "Path III: the condition number rises sharply precisely there"
    text = f"condition number {run.condition.max():.1e} at {peak:.1f} s, forces largest at {worst:.1f} s"
    yield "5.2, Fig. 10", says, "at the same time of the grid", text, peak == worst

    near = force[(run.condition >= 1e2) & (run.condition < 1e4)]
    share = np.mean(near >= 1e4)
    says = "condition number of the order of 1e2 or 1e3: forces of the order of 1e4 N or more"
    text = f"Path III, condition number {run.condition.min():.0f} to 1e4: largest |F| "
    text += f"from {near.min():.1e} N, 1e4 N or more in {share:.0%} of samples"
    yield "5.2", says, "nine tenths of samples (partly: half)", text, share > 0.9, share > 0.5


def _conclusions(found: Reproduction, form: str) -> Claims:
    runs = {name: found.runs[name, form] for name in PAPER_PATHS}
    fractions = {name: counted_fractions(run) for name, run in runs.items()}
    shares = {name: np.mean((each >= 0.2) & (each <= 0.5)) for name, each in fractions.items()}
    says = "leg inertia generally contributes 20 to 50% of the forces"
    rule = "more than half of the samples on every path (partly: a quarter on one)"
    parts = ", ".join(f"{name} {share:.0%}" for name, share in shares.items())
    text = f"samples within 20 to 50%: {parts}"
    yield "6", says, rule, text, min(shares.values()) > 0.5, max(shares.values()) > 0.25

    each = (fractions["I"], fractions["II"], counted_fractions(found.light[form]))
    slow, fast, light = (np.median(values) for values in each)
    says = "that fraction increases when the speed is high and the payload is less"
    text = f"median {slow:.1%}; ten times as fast {fast:.1%}; platform {LIGHT_PLATFORM:g} kg {light:.1%}"
    rule, more = "median rises in both cases (partly: in one)", (fast > slow, light > slow)
    yield "6", says, rule, text, all(more), any(more)

    pairs = {name: (run.condition, np.abs(run.F).max(axis=-1)) for name, run in runs.items()}
    ranks = {name: spearmanr(*pair).statistic for name, pair in pairs.items()}
    text = "rank correlation of condition number and largest |F|: "
    text += ", ".join(f"{name} {value:+.2f}" for name, value in ranks.items())
    says = "the higher the condition number, the higher the forces"
    rule = "rank correlation above 0.5 on every path (partly: on one)"
    strong = np.array([*ranks.values()]) > 0.5
    yield "6", says, rule, text, strong.all(), strong.any()
