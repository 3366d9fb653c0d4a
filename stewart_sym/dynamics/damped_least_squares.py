"""Damped least squares for H x = c, (36), if H is singular.

The method is by Nakamura and Hanafusa, J. Dyn. Sys., Meas., Control 108 (1986) 163-171. Only directions with
small singular values are damped, each by the required amount: numerical filtering by Maciejewski and Klein,
J. Robotic Systems 5 (1988) 527-552.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..io.arguments import number_in, shaped_array
from ..kinematics.conditioning import moments_over
from ..results import DampedLeastSquaresResult

SHARE = float(np.finfo(np.float64).eps) ** 0.25
"""Fraction of the largest singular value below which a singular value is damped.

Rounding in a singular value of 0 then changes the forces by sqrt(eps) of the forces that the same wrench
requires with a well-conditioned H.
"""


def damped_least_squares(
    H: ArrayLike, c: ArrayLike, length: float, rcond: float = SHARE
) -> DampedLeastSquaresResult:
    """Compute axial forces that approximately solve H x = c if H is singular, and the residual.

    Parameters
    ----------
    H : array_like, shape (..., 6, 6)
        Matrix of H x = c: forces in rows 0-2 (no unit), moments in rows 3-5 (m), as in
        ``InverseDynamicsResult`` or ``wrench_matrix``.
    c : array_like, shape (..., 6)
        Required wrench (N and N m), base frame.
    length : float
        Characteristic length (m) by which moments are divided, > 0.
    rcond : float, optional
        Smallest singular value that is not damped, relative to the largest, > 0 and < 1.

    Returns
    -------
    DampedLeastSquaresResult
        Named tuple (x, wrench_error): axial forces (N) and the residual c - H x (N and N m), shape (..., 6)
        each. NaN if H or c is not finite.

    Raises
    ------
    ValueError
        If an argument has another shape or is out of range; the message names the argument.

    See Also
    --------
    inverse_dynamics : Apply the method to singular poses with ``on_singular="damped"``.
    characteristic_length : Compute ``length`` for a robot.

    Notes
    -----
    With the moment rows of H and c divided by ``length``, H = sum s_i u_i v_i^T. The solution is x = sum g_i
    (u_i . c) v_i. The gain is g_i = 1/s_i for s_i >= s_0 = rcond s_1, and otherwise g_i = s_i/s_0^2 =
    s_i/(s_i^2 + lambda_i^2) with lambda_i^2 = s_0^2 - s_i^2. It is continuous, never exceeds 1/s_0, and is 0
    along a direction that is lost. The method is by Nakamura and Hanafusa (1986), with the numerical
    filtering of Maciejewski and Klein (1988).

    Examples
    --------
    A wrench with a moment about the z axis, which a singular H cannot produce:

    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> H = np.diag([1.0, 1.0, 1.0, 1.0, 1.0, 0.0])
    >>> result = ss.damped_least_squares(H, c=[1.0, 0.0, 2.0, 0.0, 0.0, 3.0], length=1.0)
    >>> result.x.round(6).tolist()
    [1.0, 0.0, 2.0, 0.0, 0.0, 0.0]
    >>> result.wrench_error.round(6).tolist()
    [0.0, 0.0, 0.0, 0.0, 0.0, 3.0]
    """
    rcond = number_in(rcond, "rcond", "a number > 0 and < 1", high=1.0)
    scaled, wrench = moments_over(H, length), shaped_array(c, (6,), "c")
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
