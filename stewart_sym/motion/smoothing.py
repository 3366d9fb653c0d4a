"""Smoothing of columns of samples: values, rates, second rates, and their covariance."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import deviations, real_array, shown
from ..io.array_types import Array
from ..io.toml_reader import positive
from .sample_times import elapsed
from .spline import smooth_columns

_FEWEST = 8


class SmoothSamplesResult(NamedTuple):
    """Smoothed columns at the times of the samples.

    Attributes
    ----------
    values, derivatives, second_derivatives : ndarray, shape (n, c)
        Values and derivatives of the curves.
    noise_std : ndarray, shape (c,)
        Standard deviation of the noise.
    covariance_time : ndarray, shape (n,)
        Times of the covariances.
    covariance : ndarray, shape (n, c, 6)
        Covariance of value, rate, and second rate: the lower triangle row by row.
    """

    values: Array
    derivatives: Array
    second_derivatives: Array
    noise_std: Array
    covariance_time: Array
    covariance: Array


def smooth_samples(
    time: ArrayLike, values: ArrayLike, noise_std: ArrayLike | None = None, cutoff: float | None = None
) -> SmoothSamplesResult:
    """Smooth columns of samples without phase shift.

    Parameters
    ----------
    time : array_like, shape (n,)
        Increasing times (s), at least 8.
    values : array_like, shape (n, c)
        Samples.
    noise_std : array_like, shape (c,) or (), optional
        Standard deviation of the noise of each column; by default estimated.
    cutoff : float, optional
        Frequency (Hz) at which the amplitude is halved; by default the likeliest.

    Returns
    -------
    SmoothSamplesResult
        Smoothed columns with derivatives and covariances.

    Raises
    ------
    ValueError
        If an argument is invalid; the message begins with its name.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> time = np.linspace(0.0, 2.0, 401)
    >>> noisy = np.sin(time) + np.random.default_rng(1).normal(0.0, 1e-3, 401)
    >>> smooth = ss.smooth_samples(time, noisy[:, None])
    >>> bool(np.abs(smooth.second_derivatives[:, 0] + np.sin(time)).max() < 0.1)
    True
    """
    when, columns = real_array(time, "time"), real_array(values, "values")
    if when.ndim != 1 or len(when) < _FEWEST or not (np.diff(when) > 0.0).all():
        raise ValueError(f"time: expected at least {_FEWEST} increasing times, s, (n,), got {shown(time)}")
    if columns.ndim != 2 or len(columns) != len(when) or not columns.size or not np.isfinite(columns).all():
        raise ValueError(f"values: expected finite columns ({len(when)}, c), got shape {columns.shape}")
    known = None if noise_std is None else deviations(noise_std, "noise_std", columns.shape[1:], "> 0")
    cutoff = None if cutoff is None else positive(cutoff, "cutoff")
    since = elapsed(when)
    curves = smooth_columns(since, columns, known, cutoff=cutoff)
    smooth, rates, second_rates = curves.evaluate(since)
    return SmoothSamplesResult(smooth, rates, second_rates, curves.noise_std, when, curves.covariance(since))
