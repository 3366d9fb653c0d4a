"""The figures that the project sets itself targets for, for each kind of vector instructions."""

import contextlib
from collections.abc import Callable
from dataclasses import dataclass

from ..common.output import Figures
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
    batched,
    builds_of,
    quickest,
)

BASIS = 0.228
"""Share that one pose took, 163 of 715 ns, of CasADi's plain C, unfused, when targets were set."""

Value = Callable[[Figures, str], float]
"""How a share is made of a run's builds and peaks for one kind of instructions; KeyError where it isn't."""


@dataclass(frozen=True)
class Share:
    """One figure; ``bound`` and ``goal`` are the most that it is to be, or the ``least``."""

    name: str
    value: Value
    bound: float | None = None
    goal: float | None = None
    unit: str = "ratio"
    least: bool = False


def _time(found: Figures, name: str, kind: str) -> float:
    """Ns of the quickest build."""
    build = quickest(builds_of(found, name, kind))
    if build is None:
        raise KeyError(name)
    return float(build["median"])


def _basis(found: Figures, kind: str) -> float:
    """Ns of one pose as it was when targets were set, by CasADi's unfused C."""
    built = builds_of(found, PLAIN, kind)
    if not built:
        raise KeyError(PLAIN)
    return BASIS * float(min(built, key=lambda each: len(each["flags"]))["median"])


def _limit(found: Figures, kind: str) -> float:
    """Least ns per pose, each operation filling the place of a multiply-add in a lane."""
    (limit,) = (peak["limits"] for peak in found["peaks"] if peak["instructions"] == kind)
    return float(next(iter(limit.values())))


def _over(ours: str, theirs: str) -> Value:
    return lambda found, kind: _time(found, ours, kind) / _time(found, theirs, kind)


def _over_basis(ours: str) -> Value:
    return lambda found, kind: _time(found, ours, kind) / _basis(found, kind)


def _microseconds(name: str) -> Value:
    return lambda found, kind: 1e-3 * _time(found, name, kind)


_BASIS = f"over {BASIS:g} of CasADi's unfused C"
_SHARES = (
    Share("one pose, share of CasADi's closed form", _over(ONE_POSE, CLOSED), 0.23, 0.19),
    Share("one pose, share of CasADi's plain C", _over(ONE_POSE, PLAIN), 0.18, 0.15),
    Share("batch, share of CasADi's plain C", _over(BATCH, PLAIN), 0.08, 0.06),
    Share(
        "batch, share of the limit reached",
        lambda found, kind: _limit(found, kind) / _time(found, BATCH, kind),
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


def shares(found: Figures) -> list[Figures]:
    """Every figure that a run has the times of, by kind of instructions, with its bound and its goal."""
    made = []
    for share in _SHARES:
        values = {}
        for peak in found["peaks"]:
            with contextlib.suppress(KeyError):
                values[peak["instructions"]] = share.value(found, peak["instructions"])
        limits = {"at_least" if share.least else "at_most": share.bound, "goal": share.goal}
        stated = {name: limit for name, limit in limits.items() if limit is not None}
        if values:
            made.append({"name": share.name, "unit": share.unit, "values": values, **stated})
    return made
