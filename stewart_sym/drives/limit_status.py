"""Whether limits are kept: one rule for every quantity, with the deviations that noise in a log leaves."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array, Flags
from ..robot.robot import LEGS, legs_text

SURE = 3.0
"""Deviations within which a value is taken to lie: 99.7 % of normal errors."""

USED_UP = 1e-6
"""Share of a limit by which a motion planned at it, or stopped by it, exceeds it by its own rounding."""

WITHIN, EXCEEDED, NOT_DECIDED = "within_limit", "exceeded", "inconclusive_noise"
AT_REPLACED = "inconclusive_replaced_rows"
VERDICTS = (WITHIN, AT_REPLACED, NOT_DECIDED, EXCEEDED)
"""By their codes: that of several instants is the largest of theirs."""

# Deviation, as a share of a leg's peak force, from which on forces count as unknown.
_UNKNOWN = 1.0 / 3.0
_TINY = float(np.finfo(np.float64).tiny)


Sides = tuple[Array, Array]
"""Deviations upward and downward."""


def status_codes(
    sizes: Array, limits: Array, sd: Array | Sides | None = None, there: Flags | None = None
) -> NDArray[np.uint8]:
    """Places in ``VERDICTS``, (n, m), of sizes at instants, (n, m), for limits, (m,).

    sd: deviations of the sizes, (n, m). there: instants, (n,), at which these hold what replaced rows change;
    ``AT_REPLACED`` where they alone leave a limit open.
    """
    up, down = _sides(sd)
    sure, maybe = sizes - SURE * down > limits, sizes + SURE * up > limits
    at = np.zeros(len(sizes), dtype=bool) if there is None else there
    alone = at[:, None] & ~(sizes > limits)
    found = np.where(maybe, np.where(alone, VERDICTS.index(AT_REPLACED), VERDICTS.index(NOT_DECIDED)), 0)
    return np.where(sure, VERDICTS.index(EXCEEDED), found).astype(np.uint8)


def limit_status(
    sizes: Array, limits: Array, sd: Array | Sides | None = None, there: Flags | None = None
) -> list[str]:
    """The verdict of each column, (n, m), for limits, (m,); arguments as of ``status_codes``."""
    return [VERDICTS[code] for code in status_codes(sizes, limits, sd, there).max(axis=0, initial=0)]


def _sides(sd: Array | Sides | None) -> Sides:
    if sd is None:
        return np.zeros(()), np.zeros(())
    return sd if isinstance(sd, tuple) else (sd, sd)


def farthest(sizes: Array, sd: Array | Sides | None, verdict: str) -> int:
    """Which of the sizes of one leg, (n,), makes the verdict."""
    return int(np.argmax(_scores(sizes, sd, verdict)))


def _scores(sizes: Array, sd: Array | Sides | None, verdict: str) -> Array:
    """Sizes as they count for a verdict, -inf where there are none."""
    up, down = _sides(sd)
    scores = sizes - SURE * down if verdict == EXCEEDED else sizes + SURE * up
    return np.asarray(np.where(np.isnan(scores), -np.inf, scores))


class Beyond(NamedTuple):
    """A verdict about a limit: legs that it holds for, counted from 0, and the worst of them.

    size, sd, when: the worst one's where it makes the verdict; sd is None without noise.
    """

    verdict: str
    legs: list[int]
    worst: int
    size: float
    sd: float | None
    when: Any

    @property
    def legs_text(self) -> str:
        """Legs as they are named: ``leg 1``, ``legs 1, 2``."""
        return legs_text(self.legs)

    @property
    def worst_text(self) -> str:
        """What names the worst of several legs, as a prefix."""
        return "" if len(self.legs) == 1 else f"worst leg {self.worst + 1}: "


class Extremes:
    """Instants of a run at which sizes of six legs are largest, surely, possibly or as they are."""

    def __init__(self) -> None:
        self._sizes: list[Array] = []
        self._up: list[Array] = []
        self._down: list[Array] = []
        self._there: list[Flags] = []
        self._when: list[Any] = []

    def add(
        self,
        sizes: Array,
        when: Callable[[list[int]], Iterable[Any]],
        sd: Array | Sides | None = None,
        there: Flags | None = None,
    ) -> None:
        """Take in instants, (n, 6), n > 0, NaN where there are none; when: what names some of them.

        sd, there: as for ``limit_status``.
        """
        sizes = np.where(np.isnan(sizes), -np.inf, sizes)
        scores, flags = [sizes], np.zeros(len(sizes), dtype=bool) if there is None else there
        if sd is not None:
            up, down = _sides(sd)
            apart = np.where(flags[:, None], np.nan, 0.0)
            scores += [sizes + SURE * x for x in (up, -down, up + apart, -down + apart)]
        all_scores = np.hstack(scores)
        i = np.unique(np.argmax(np.where(np.isnan(all_scores), -np.inf, all_scores), axis=0))
        self._sizes.append(sizes[i])
        self._there.append(flags[i])
        self._when.extend(when(i.tolist()))
        if sd is not None:
            self._up.append(up[i])
            self._down.append(down[i])

    def _deviations(self) -> Sides | None:
        return (np.concatenate(self._up), np.concatenate(self._down)) if self._up else None

    @property
    def instants(self) -> tuple[list[Any], Flags, Array | None]:
        """What names them, which are those of replaced rows, (k,), and deviations upward, (k, 6), if any."""
        return self._when, np.concatenate(self._there), np.concatenate(self._up) if self._up else None

    @property
    def largest(self) -> Array:
        """Largest sizes, (6,), -inf where there are none."""
        return np.asarray(np.concatenate([np.full((1, LEGS), -np.inf), *self._sizes]).max(axis=0))

    @property
    def peaks(self) -> Array:
        """Largest sizes, (6,), at least 0."""
        return np.maximum(self.largest, 0.0)

    @property
    def peak_sd(self) -> Array | None:
        """Deviations of the largest sizes where these are, (6,); None without noise."""
        sd = self._deviations()
        if sd is None:
            return None
        at = np.argmax(np.concatenate(self._sizes), axis=0)
        return np.asarray(np.maximum(*sd)[at, np.arange(LEGS)])

    def verdicts(self, limits: Array) -> list[str]:
        """As ``limit_status``, for limits (6,)."""
        if not self._sizes:
            return [WITHIN] * LEGS
        return limit_status(
            np.concatenate(self._sizes), limits, self._deviations(), np.concatenate(self._there)
        )

    def beyond(self, limits: Array) -> Iterator[Beyond]:
        """Every verdict but ``WITHIN`` that holds for a leg."""
        found = self.verdicts(limits)
        for verdict in (EXCEEDED, NOT_DECIDED, AT_REPLACED):
            legs = [leg for leg in range(LEGS) if found[leg] == verdict]
            if legs:
                yield self._worst(verdict, legs, limits)

    def _worst(self, verdict: str, legs: list[int], limits: Array) -> Beyond:
        sizes, sd = np.concatenate(self._sizes), self._deviations()
        scores = _scores(sizes, sd, verdict)
        at = np.argmax(scores, axis=0)
        with np.errstate(invalid="ignore"):
            excess = (scores[at, np.arange(LEGS)] - limits) / np.maximum(np.abs(limits), _TINY)
        worst = max(legs, key=lambda leg: float(excess[leg]))
        i = int(at[worst])
        off = None if sd is None else float(np.maximum(*sd)[i, worst])
        return Beyond(verdict, legs, worst, float(sizes[i, worst]), off, self._when[i])


def amount_text(value: float, sd: float | None, digits: int = 6) -> str:
    """A value with its deviation, ``1.234 +- 0.012``, or alone where its digits don't show that."""
    text = f"{value:.{digits}g}"
    return text if sd is None or not shows(value, sd, digits) else f"{text} +- {spread_text(sd)}"


def spread_text(sd: float) -> str:
    """A deviation: two digits of it."""
    return f"{float(f'{sd:.2g}'):g}"


def shows(values: Array | float, sd: Array | float, digits: int) -> Flags:
    """Whether deviations reach half of the last of so many digits of their values."""
    with np.errstate(divide="ignore"):
        last = 10.0 ** (np.floor(np.log10(np.abs(values))) - digits + 1)
    return np.asarray(np.greater(sd, 0.0) & np.greater_equal(sd, 0.5 * last))


def unknown_forces(F: Array, sd: Array) -> str | None:
    """One line about legs whose peak force, of (n, 6), N, is not known by its deviation; None without."""
    peaks = np.argmax(np.nan_to_num(np.abs(F), nan=-1.0), axis=0), np.arange(F.shape[1])
    force, off = np.abs(F)[peaks], sd[peaks]
    legs = np.flatnonzero(off > _UNKNOWN * force).tolist()
    if not legs:
        return None
    worst = max(legs, key=lambda leg: float(off[leg]))
    return (
        f"the log's noise leaves the forces of {legs_text(legs)} unknown: "
        f"{amount_text(force[worst], off[worst], 4)} N at the peak of leg {worst + 1}; what helps: "
        "a lower --cutoff, a slower motion, more rows before and after it, or poses that are measured better"
    )
