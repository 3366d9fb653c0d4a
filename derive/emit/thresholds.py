"""Where a status begins, and why there: what the kernels were seen to do on this side of each threshold.

Figures of the sweep over random poses near failure that ``stewart-sym stability`` makes, for the emitted
header; the tests hold them to the sweep's last run.
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Threshold:
    """Where one status begins.

    status: its name. kind: of near failure, as the sweep calls it. begins: in words. worst: largest error
    seen with status ok, in rounding units times the condition number of the problem itself, rounded up;
    where: at which distance from the failure that was.
    """

    status: str
    kind: str
    begins: str
    worst: int
    where: str


CASES = 1_000_000
"""Random poses of the sweep, in double."""

THRESHOLDS = (
    Threshold(
        "ZERO_LENGTH",
        "zero-length leg",
        "within 16 rounding units of the vectors it is the sum of",
        7,
        "2.2e-01",
    ),
    Threshold("JOINT_SINGULAR", "joint singularity", "sine below 4096 rounding units", 10, "5.9e-02"),
    Threshold(
        "SINGULAR",
        "singular",
        "spectral radius of |1/H| times the bounds of its errors above 1/2",
        10,
        "1.6e-10",
    ),
)


def comment() -> str:
    """The thresholds as lines of a C comment."""
    lines = [
        f"Where a status begins, and the worst error seen on this side of it among 10^{len(str(CASES)) - 1}",
        "random poses near failure, in rounding units times the condition number of the problem itself, at",
        "which distance from the failure (`stewart-sym stability`):",
        *(f"STEWART_{each.status}: {each.begins}; {each.worst}, at {each.where}" for each in THRESHOLDS),
    ]
    return "/* " + "\n * ".join(lines) + " */"
