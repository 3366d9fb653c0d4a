"""The figures that the project sets itself targets for, for each kind of vector instructions."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from .samples import (
    BATCH,
    CLOSED,
    DERIVATIVES,
    EQUATIONS,
    FLOAT,
    FORWARD,
    INVERSE,
    ONE_POSE,
    PLAIN,
    REGRESSOR,
    Figure,
    Peak,
    batched,
)

BASIS = 0.228
"""Share that one pose took, 163 of 715 ns, of CasADi's plain C, unfused, when targets were set."""


@dataclass(frozen=True)
class Measured:
    """All compiled C, and the limits of a batch's operations, of one run."""

    builds: Sequence[Figure]
    peaks: Sequence[Peak]
    operations: int

    def fastest(self, name: str, target: str) -> Figure | None:
        """The fastest build of that name for a target; None without one."""
        return min(self._builds(name, target), key=lambda figure: figure.median, default=None)

    def time(self, name: str, target: str) -> float:
        """Its ns; KeyError without one."""
        found = self.fastest(name, target)
        if found is None:
            raise KeyError(name)
        return found.median

    def basis(self, target: str) -> float:
        """Ns of one pose as it was when targets were set, by CasADi's unfused C; KeyError without."""
        found = self._builds(PLAIN, target)
        if not found:
            raise KeyError(PLAIN)
        return BASIS * min(found, key=lambda figure: len(figure.flags)).median

    def _builds(self, name: str, target: str) -> list[Figure]:
        return [figure for figure in self.builds if (figure.name, figure.target) == (name, target)]

    def limit(self, target: str) -> float:
        """Least ns per pose, each operation filling the place of a multiply-add in a lane."""
        (peak,) = (peak for peak in self.peaks if peak.target == target)
        return next(iter(peak.limits(self.operations).values()))


@dataclass(frozen=True)
class Share:
    """One figure by target; ``bound`` and ``goal`` are the most that it is to be, or the ``least``.

    value: how it is made of a run's times for one kind of instructions. values: what it then is.
    """

    name: str
    value: Callable[[Measured, str], float]
    bound: float | None = None
    goal: float | None = None
    unit: str = "ratio"
    least: bool = False
    values: Mapping[str, float] = field(default_factory=dict)

    def as_json(self) -> dict[str, Any]:
        """Every field that says something, ready for ``json``."""
        limits = {"at_least" if self.least else "at_most": self.bound, "goal": self.goal}
        set_ = {name: limit for name, limit in limits.items() if limit is not None}
        return {"name": self.name, "unit": self.unit, "values": dict(self.values), **set_}


def _over(ours: str, theirs: str) -> Callable[[Measured, str], float]:
    return lambda found, target: found.time(ours, target) / found.time(theirs, target)


def _over_basis(ours: str) -> Callable[[Measured, str], float]:
    return lambda found, target: found.time(ours, target) / found.basis(target)


def _microseconds(name: str) -> Callable[[Measured, str], float]:
    return lambda found, target: 1e-3 * found.time(name, target)


_BASIS = f"over {BASIS:g} of CasADi's unfused C"
_SHARES = (
    Share("one pose, share of CasADi's closed form", _over(ONE_POSE, CLOSED), 0.23, 0.19),
    Share("one pose, share of CasADi's plain C", _over(ONE_POSE, PLAIN), 0.18, 0.15),
    Share("batch, share of CasADi's plain C", _over(BATCH, PLAIN), 0.08, 0.06),
    Share(
        "batch, share of the limit reached",
        lambda found, target: found.limit(target) / found.time(BATCH, target),
        0.60,
        0.75,
        least=True,
    ),
    Share("batch, float, share of CasADi's plain C", _over(FLOAT, PLAIN), 0.045, 0.035),
    Share("equations, over inverse dynamics", _over(EQUATIONS, INVERSE)),
    Share("forward dynamics, over inverse dynamics", _over(FORWARD, INVERSE)),
    Share("derivatives, over inverse dynamics", _over(DERIVATIVES, INVERSE)),
    Share(f"equations, {_BASIS}", _over_basis(EQUATIONS), 1.6, 1.3),
    Share(f"forward dynamics, {_BASIS}", _over_basis(FORWARD), 1.2, 1),
    Share(f"derivatives, {_BASIS}", _over_basis(DERIVATIVES), 4, 3),
    Share("regressor 6 x 148, one pose", _microseconds(REGRESSOR), 1.5, 0.7, "us"),
    Share("regressor 6 x 148, batch", _microseconds(batched(REGRESSOR)), unit="us"),
)


def shares(found: Measured) -> tuple[Share, ...]:
    """Every figure that the run has the times of."""
    made = (_of(share, found) for share in _SHARES)
    return tuple(share for share in made if share.values)


def _of(share: Share, found: Measured) -> Share:
    values = {}
    for peak in found.peaks:
        try:
            values[peak.target] = share.value(found, peak.target)
        except KeyError:
            continue
    return replace(share, values=values)
