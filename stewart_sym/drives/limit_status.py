"""Status of limits: one rule for every quantity, with the standard deviations caused by noise in a log."""

from collections.abc import Mapping
from typing import Any

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


def counts_text(verdicts: Mapping[str, str]) -> str:
    """Count and name the limits that are not exceeded, exceeded, and inconclusive, from name and status."""
    if not verdicts:
        return "limits: none stated"
    groups: dict[str, list[str]] = {"not exceeded": [], "exceeded": [], "inconclusive": []}
    for name, verdict in verdicts.items():
        groups[{WITHIN: "not exceeded", EXCEEDED: "exceeded"}.get(verdict, "inconclusive")].append(name)
    counts = [
        f"{len(names)} {group}" + f" ({', '.join(names)})" * bool(names) for group, names in groups.items()
    ]
    return f"limits: {', '.join(counts)}"


def _scores(sizes: Array, sd: Array | Sides | None, verdict: str) -> Array:
    """Return the magnitudes that are compared for a status, -inf for NaN."""
    up, down = _sides(sd)
    scores = sizes - SURE * down if verdict == EXCEEDED else sizes + SURE * up
    return np.asarray(np.where(np.isnan(scores), -np.inf, scores))


def sides(std: Mapping[str, Array] | None, name: str) -> Sides | None:
    """Return the standard deviations, shape (n, 6), of the magnitude of a quantity, upward and downward."""
    if std is None or name not in std:
        return None
    return std.get(f"{name}_rise", std[name]), std.get(f"{name}_fall", std[name])


class Extremes:
    """Samples with the largest magnitudes of six legs: certain, possible, and nominal."""

    def __init__(self) -> None:
        nothing = np.full((1, LEGS), -np.inf), *np.zeros((3, 1, LEGS))
        self._parts = [(*nothing, np.array([-1]), np.array([False]))]
        self._noisy = False

    def add(
        self, sizes: Array, values: Array, first: int, sd: Sides | None = None, there: Flags | None = None
    ) -> None:
        """Add n > 0 samples of magnitudes, shape (n, 6), NaN if missing, from the index ``first`` on.

        ``values`` have the signs. ``sd`` and ``there`` are as in ``status_codes``.
        """
        sizes, flags = np.where(np.isnan(sizes), -np.inf, sizes), np.zeros(len(sizes), dtype=bool)
        flags = flags if there is None else there
        up, down = (np.broadcast_to(each, sizes.shape) for each in _sides(sd))
        scores = [sizes]
        if sd is not None:
            self._noisy = True
            apart = np.where(flags[:, None], np.nan, 0.0)
            spreads = (up, -down, up + apart, -down + apart) if flags.any() else (up, -down)
            scores += [sizes + SURE * x for x in spreads]
        all_scores = np.hstack(scores)
        i = np.unique(np.argmax(np.where(np.isnan(all_scores), -np.inf, all_scores), axis=0))
        self._parts.append((sizes[i], values[i], up[i], down[i], first + i, flags[i]))

    def _all(self) -> list[Any]:
        """Return magnitudes, values, deviations upward and downward, indices, and flags of the samples."""
        return [np.concatenate(each) for each in zip(*self._parts, strict=True)]

    @property
    def samples(self) -> tuple[NDArray[np.intp], Array, Flags, Array | None]:
        """Indices, values (k, 6), flags of replaced rows (k,), and upward deviations (k, 6) or None."""
        _, values, up, _, index, flags = (each[1:] for each in self._all())
        return index, values, flags, up if self._noisy else None

    @property
    def largest(self) -> Array:
        """Largest magnitudes, shape (6,); -inf without samples."""
        return np.asarray(self._all()[0].max(axis=0))

    @property
    def peak_sd(self) -> Array | None:
        """Standard deviations of the largest magnitudes, shape (6,); None without noise."""
        sizes, _, up, down, *_ = self._all()
        at = np.argmax(sizes, axis=0)
        return np.asarray(np.maximum(up, down)[at, np.arange(LEGS)]) if self._noisy else None

    def verdicts(self, limits: Array) -> list[str]:
        """Return the status of each leg for limits (6,), as ``limit_status``."""
        sizes, _, up, down, _, flags = self._all()
        return limit_status(sizes, limits, (up, down), flags)

    def worst(self, verdict: str, legs: list[int], limits: Array) -> tuple[int, int, float, float | None]:
        """Return the leg farthest beyond its limit, the index of the sample, value, and deviation if any."""
        sizes, values, up, down, index, _ = self._all()
        scores = _scores(sizes, (up, down), verdict)
        with np.errstate(invalid="ignore"):
            excess = (scores.max(axis=0) - limits) / np.maximum(np.abs(limits), _TINY)
        worst = max(legs, key=lambda leg: float(excess[leg]))
        i = int(np.argmax(scores[:, worst]))
        sd = float(max(up[i, worst], down[i, worst])) if self._noisy else None
        return worst, int(index[i]), float(values[i, worst]), sd


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
