"""A smooth bound of the largest force of a leg along a path, with derivatives by the spline of its rates."""

from dataclasses import dataclass

import numpy as np

from ...io.array_types import Array
from ...robot.robot import LEGS
from ..timing.path_terms import Terms
from .rate_spline import in_cells

# How much nearness to the usual motion counts, over the spread of the bound.
_USUAL = 1.0


@dataclass(frozen=True, eq=False)
class PeakCost:
    """Largest force, N, as log(mean of exp(sharpness force)) / sharpness: the sharper, the nearer.

    A little of the mean of y / usual + usual / y is added: of many motions with one peak it takes one near
    to a usual motion, which stops nowhere.

    form: coefficients of the forces, N, by (x'', y, sqrt(y), 1), (4, cells, 5, 6). sharpness: 1/N. usual: y
    of that motion, (cells, 5).
    """

    form: Array
    sharpness: float
    usual: Array

    @classmethod
    def of(cls, terms: Terms, usual: Array, v: Array, sharpness: float) -> "PeakCost":
        """The cost by terms at the ends of all parts of cells; usual, v: y and derivatives of two motions.

        sharpness: over the peak of the second.
        """
        form = np.stack([in_cells(x[:, :LEGS]) for x in (terms.a, terms.b, terms.d, terms.e)])
        return cls(form, sharpness / float(np.abs(_forces(form, v)).max()), usual[..., 0])

    def __call__(self, v: Array) -> tuple[float, Array, Array]:
        """Cost and its first and second derivatives by y, y' and y'' at the samples; convex parts alone."""
        a, b, d, _ = self.form
        y, F = v[..., 0, None], _forces(self.form, v)
        side, size, sharpness = np.sign(F), np.abs(F), self.sharpness
        largest = float(size.max())
        each = np.exp(sharpness * (size - largest))
        share = each / each.sum()
        slope = side[..., None] * np.stack([b + 0.5 * d / np.sqrt(y), 0.5 * a], axis=-1)
        by, twice = np.zeros_like(v), np.zeros((*v.shape, 3))
        by[..., :2] = np.einsum("ikl,ikla->ika", share, slope)
        twice[..., :2, :2] = np.einsum("ikl,ikla,iklb->ikab", sharpness * share, slope, slope)
        twice[..., 0, 0] += np.sum(share * np.maximum(-0.25 * side * d * y**-1.5, 0.0), axis=-1)
        weight, ratio = _USUAL / sharpness / self.usual.size, v[..., 0] / self.usual
        by[..., 0] += weight * (1.0 - ratio**-2) / self.usual
        twice[..., 0, 0] += weight * 2.0 * ratio**-3 / self.usual**2
        apart = weight * float(np.sum(ratio + 1.0 / ratio - 2.0))
        return apart + largest + float(np.log(each.mean())) / sharpness, by, twice


def _forces(form: Array, v: Array) -> Array:
    """Forces of the legs at the samples, N, (cells, 5, 6)."""
    a, b, d, e = form
    y, y_1 = v[..., 0, None], v[..., 1, None]
    return np.asarray(0.5 * a * y_1 + b * y + d * np.sqrt(y) + e)
