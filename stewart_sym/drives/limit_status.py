"""Status of limits: one rule for every quantity, with the standard deviations caused by noise in a log."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..io.array_types import Array, Flags
from ..robot.robot import LEGS, legs_text

SURE = 3.0
"""Number of standard deviations that contain a value with certainty: 99.7 % of normal errors."""

USED_UP = 1e-6
"""Relative tolerance of a limit for the rounding of motions that are planned at it or stopped by it."""

WITHIN, EXCEEDED, INCONCLUSIVE_NOISE = "within_limit", "exceeded", "inconclusive_noise"
INCONCLUSIVE_REPLACED_ROWS = "inconclusive_replaced_rows"
VERDICTS = (WITHIN, INCONCLUSIVE_REPLACED_ROWS, INCONCLUSIVE_NOISE, EXCEEDED)
"""Status names in the order of their codes; the largest code of several samples is their common status."""

# Standard deviation, relative to the peak force of a leg, above which forces are unknown.
_UNKNOWN = 1.0 / 3.0
_TINY = float(np.finfo(np.float64).tiny)


Sides = tuple[Array, Array]
"""Standard deviations of magnitudes, upward and downward."""


def status_codes(
    sizes: Array, limits: Array, sd: Array | Sides | None = None, there: Flags | None = None
) -> NDArray[np.uint8]:
    """Return the codes, indices of ``VERDICTS``, of magnitudes (n, m) for limits (m,), shape (n, m).

    ``sd`` contains the standard deviations of the magnitudes, shape (n, m). ``there`` marks samples, shape
    (n,), whose standard deviations include replaced rows. If only these samples make a limit inconclusive,
    the status is ``INCONCLUSIVE_REPLACED_ROWS``.
    """
    up, down = _sides(sd)
    sure, maybe = sizes - SURE * down > limits, sizes + SURE * up > limits
    at = np.zeros(len(sizes), dtype=bool) if there is None else there
    alone = at[:, None] & ~(sizes > limits)
    found = np.where(
        maybe,
        np.where(alone, VERDICTS.index(INCONCLUSIVE_REPLACED_ROWS), VERDICTS.index(INCONCLUSIVE_NOISE)),
        0,
    )
    return np.where(sure, VERDICTS.index(EXCEEDED), found).astype(np.uint8)


def limit_status(
    sizes: Array, limits: Array, sd: Array | Sides | None = None, there: Flags | None = None
) -> list[str]:
    """Return the status of each column of magnitudes (n, m) for limits (m,), as in ``status_codes``."""
    return [VERDICTS[code] for code in status_codes(sizes, limits, sd, there).max(axis=0, initial=0)]


def _sides(sd: Array | Sides | None) -> Sides:
    if sd is None:
        return np.zeros(()), np.zeros(())
    return sd if isinstance(sd, tuple) else (sd, sd)


def counts_text(verdicts: Sequence[Sequence[str]]) -> str:
    """Count the limits that are not exceeded, exceeded, and inconclusive, from the status of each leg."""
    worst = [max(legs, key=VERDICTS.index) for legs in verdicts]
    if not worst:
        return "limits: none stated"
    within, exceeded = worst.count(WITHIN), worst.count(EXCEEDED)
    inconclusive = len(worst) - within - exceeded
    return f"limits: {within} not exceeded, {exceeded} exceeded, {inconclusive} inconclusive"


def farthest(sizes: Array, sd: Array | Sides | None, verdict: str) -> int:
    """Return the index of the magnitude of a leg, shape (n,), that determines the status."""
    return int(np.argmax(_scores(sizes, sd, verdict)))


def _scores(sizes: Array, sd: Array | Sides | None, verdict: str) -> Array:
    """Return the magnitudes that are compared for a status, -inf for NaN."""
    up, down = _sides(sd)
    scores = sizes - SURE * down if verdict == EXCEEDED else sizes + SURE * up
    return np.asarray(np.where(np.isnan(scores), -np.inf, scores))


class Beyond(NamedTuple):
    """Status of a limit with its legs, counted from 0, and the worst leg.

    size, sd, when: value, standard deviation (None without noise), and time of the worst leg.
    """

    verdict: str
    legs: list[int]
    worst: int
    size: float
    sd: float | None
    when: Any

    def needed_noise(self, limit: float) -> str:
        """Return a text with the noise at which an inconclusive limit is decided, otherwise an empty text."""
        if self.verdict == EXCEEDED or not self.sd or not np.isfinite(self.sd):
            return ""
        share = abs(limit - self.size) / (SURE * self.sd)
        return f"; needs noise below {100.0 * share:.2g} % of the noise here"

    @property
    def legs_text(self) -> str:
        """Names of the legs: ``leg 1``, ``legs 1, 2``."""
        return legs_text(self.legs)

    @property
    def worst_text(self) -> str:
        """Prefix that names the worst of several legs."""
        return "" if len(self.legs) == 1 else f"worst leg {self.worst + 1}: "


class Extremes:
    """Samples with the largest magnitudes of six legs: certain, possible, and nominal."""

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
        """Add n > 0 samples of magnitudes, shape (n, 6), NaN if missing.

        ``when`` returns the names of samples. ``sd`` and ``there`` are as in ``limit_status``.
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
    def samples(self) -> tuple[list[Any], Flags, Array | None]:
        """Names of the samples, flags of replaced rows (k,), upward standard deviations (k, 6) or None."""
        return self._when, np.concatenate(self._there), np.concatenate(self._up) if self._up else None

    @property
    def largest(self) -> Array:
        """Largest magnitudes, shape (6,); -inf without samples."""
        return np.asarray(np.concatenate([np.full((1, LEGS), -np.inf), *self._sizes]).max(axis=0))

    @property
    def peaks(self) -> Array:
        """Largest magnitudes, shape (6,), at least 0."""
        return np.maximum(self.largest, 0.0)

    @property
    def peak_sd(self) -> Array | None:
        """Standard deviations of the largest magnitudes, shape (6,); None without noise."""
        sd = self._deviations()
        if sd is None:
            return None
        at = np.argmax(np.concatenate(self._sizes), axis=0)
        return np.asarray(np.maximum(*sd)[at, np.arange(LEGS)])

    def verdicts(self, limits: Array) -> list[str]:
        """Return the status of each leg for limits (6,), as ``limit_status``."""
        if not self._sizes:
            return [WITHIN] * LEGS
        return limit_status(
            np.concatenate(self._sizes), limits, self._deviations(), np.concatenate(self._there)
        )

    def beyond(self, limits: Array) -> Iterator[Beyond]:
        """Yield every status other than ``WITHIN`` with its legs."""
        found = self.verdicts(limits)
        for verdict in (EXCEEDED, INCONCLUSIVE_NOISE, INCONCLUSIVE_REPLACED_ROWS):
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
    """Return a value with its standard deviation, ``1.234 +- 0.012``, if it affects the digits."""
    text = f"{value:.{digits}g}"
    return text if sd is None or not shows(value, sd, digits) else f"{text} +- {spread_text(sd)}"


def spread_text(sd: float) -> str:
    """Return a standard deviation with two digits as text."""
    return f"{float(f'{sd:.2g}'):g}"


def shows(values: Array | float, sd: Array | float, digits: int) -> Flags:
    """Return True if standard deviations reach half a unit of the last digit of their values."""
    with np.errstate(divide="ignore"):
        last = 10.0 ** (np.floor(np.log10(np.abs(values))) - digits + 1)
    return np.asarray(np.greater(sd, 0.0) & np.greater_equal(sd, 0.5 * last))


def unknown_forces(F: Array, sd: Array) -> str | None:
    """Return a warning text about legs whose peak force (N) is unknown at this noise level, else None."""
    peaks = np.argmax(np.nan_to_num(np.abs(F), nan=-1.0), axis=0), np.arange(F.shape[1])
    force, off = np.abs(F)[peaks], sd[peaks]
    legs = np.flatnonzero(off > _UNKNOWN * force).tolist()
    if not legs:
        return None
    worst = max(legs, key=lambda leg: float(off[leg]))
    return (
        f"at the noise of the log, the forces of {legs_text(legs)} are unknown: "
        f"{amount_text(force[worst], off[worst], 4)} N at the peak of leg {worst + 1}; "
        "use a lower --cutoff, a slower motion, more rows before and after it, or more accurate poses"
    )
