"""Damped least squares: axial forces where H is singular and no x solves H x = c, (36).

The method is that of Nakamura and Hanafusa, J. Dyn. Sys., Meas., Control 108 (1986) 163-171, damped only in
the directions that are all but lost, by as much as their singular values need: the numerical filtering
of Maciejewski and Klein, J. Robotic Systems 5 (1988) 527-552.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import number_in, real_array
from ..kinematics.conditioning import moments_over
from ..results import DampedLeastSquaresResult

SHARE = float(np.finfo(np.float64).eps) ** 0.25
"""Share of the largest singular value below which one is damped: rounding in a singular value of 0 then moves
the forces by sqrt(eps) of what the same wrench needs with a well-conditioned H."""


def damped_least_squares(
    H: ArrayLike, c: ArrayLike, length: float, rcond: float = SHARE
) -> DampedLeastSquaresResult:
    """Return x, N, (..., 6), that least violates H x = c with forces kept within bounds, and c - H x.

    With the moment rows of H and c divided by ``length``, m (``characteristic_length``), H = sum s_i u_i
    v_i^T. x = sum g_i (u_i . c) v_i with g_i = 1/s_i where s_i >= s_0 = share s_1, and g_i = s_i/s_0^2 =
    s_i/(s_i^2 + lambda_i^2), lambda_i^2 = s_0^2 - s_i^2, below: without a jump, never above 1/s_0, and 0
    along a motion that is lost. They are returned as a named tuple (x, wrench_error).

    Parameters
    ----------
    H : array_like
        (..., 6, 6).
    c : array_like
        N and N m, (..., 6).
    length : float
        Characteristic length, m.
    rcond : float, optional
        Smallest singular value that is not damped, over the largest, > 0 and < 1.

    Returns
    -------
    DampedLeastSquaresResult
        Forces x and the residual c - H x, N and N m, (..., 6): the error of the wrench.
        NaN where H or c is not finite.

    Raises
    ------
    ValueError
        Naming the argument.
    """
    rcond = number_in(rcond, "rcond", "a number > 0 and < 1", high=1.0)
    scaled, wrench = moments_over(H, length), real_array(c, "c", "wrenches of shape (..., 6)")
    if wrench.shape[-1:] != (6,):
        raise ValueError(f"c: expected wrenches of shape (..., 6), got shape {wrench.shape}")
    unit = np.repeat([1.0, length], 3)
    finite = np.asarray(np.isfinite(scaled).all(axis=(-2, -1)))
    U, s, V_T = np.linalg.svd(np.where(finite[..., None, None], scaled, 0.0))
    s_0 = rcond * s[..., :1]
    square = np.maximum(s, s_0) ** 2
    gain = np.divide(s, square, out=np.zeros_like(s), where=square > 0.0)
    along = np.einsum("...ij,...i->...j", U, wrench / unit)
    x = np.einsum("...ij,...i->...j", V_T, gain * along)
    x = np.where(finite[..., None] & np.isfinite(wrench).all(axis=-1, keepdims=True), x, np.nan)
    return DampedLeastSquaresResult(x, np.asarray(wrench - unit * np.einsum("...ij,...j->...i", scaled, x)))
