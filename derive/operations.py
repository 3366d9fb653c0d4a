"""Operation counts of a whole kernel: six legs, platform, sum of c, solve, F = D - x.

Counts +, -, *, / and sqrt one each; negation, copies, comparisons and absolute values are free. Knows blocks
and the elimination that the emitters print, not their text.
"""

from dataclasses import dataclass

from . import notation as n
from .block import Operations
from .kernels import Kernel
from .prepared import arm_c
from .regroup import ForceKernel

LEGS = 6
NOTHING = Operations()
PIVOTS = Operations(mul=LEGS - 1)
"""Of the product of the pivots, where it finds the poses that may be singular."""


@dataclass(frozen=True)
class KernelOperations:
    """Counts of one pose of inverse dynamics, part by part; moments: of those of legs 2 to 6 made apart."""

    leg: Operations
    platform: Operations
    sum_c: Operations
    solve: Operations
    forces: Operations
    moments: Operations = NOTHING

    @property
    def total(self) -> Operations:
        """Everything: six legs, the platform's part, moments, the sum of c, the solve, F = D - x."""
        parts = self.platform + (LEGS - 1) * self.moments + self.sum_c + self.solve + self.forces
        return LEGS * self.leg + parts

    def parts(self) -> dict[str, Operations]:
        """The counts by name, the total last."""
        return {
            "leg": self.leg,
            "platform": self.platform,
            **({"moments": self.moments} if self.moments.total else {}),
            "sum of c": self.sum_c,
            "solve": self.solve,
            "forces": self.forces,
            "total": self.total,
        }


def elimination(size: int, first_column: int | None = None, last_divided: bool = False) -> Operations:
    """Gaussian elimination of ``size`` equations with one right side, reciprocal pivots.

    first_column: how many rows have an entry in the first column; None for all. last_divided: the last
    unknown is had by division instead of a reciprocal and a product.
    """
    below = [size - k - 1 for k in range(size)]
    below[0] = (first_column or size) - 1
    update = sum(rows * (size - k) for k, rows in enumerate(below))
    back = size * (size - 1) // 2
    return Operations(mul=sum(below) + update + back + size - last_divided, add=update + back, div=size)


def kernel_operations(kernel: Kernel) -> KernelOperations:
    """Counts of a kernel as it is (share its blocks first to count what is emitted)."""
    return KernelOperations(
        leg=kernel.leg.operations(),
        platform=kernel.platform.operations(),
        sum_c=Operations(add=6 * LEGS),
        solve=elimination(LEGS),
        forces=Operations(add=LEGS),
    )


def force_operations(kernel: ForceKernel, product: bool = False) -> KernelOperations:
    """Counts of a regrouped kernel as it is; ``platform`` holds what the pose has for all legs.

    What a leg does not have, its part of c or its D, costs nothing to add. product: whether the solve has the
    product of the pivots.
    """
    given = {out.quantity for out in kernel.leg.outputs}
    sums = LEGS * sum(3 for quantity in (n.c_force, n.c_moment) if quantity in given)
    moments, shift = Operations(), Operations()
    solve = elimination(LEGS, 3 if kernel.about_tip else LEGS, last_divided=True)
    if kernel.about_tip:
        moments, shift = kernel.moments.operations(), kernel.shift.operations()
        sums += (LEGS - 1) * sum(3 for out in kernel.moments.outputs if out.quantity == arm_c)
    return KernelOperations(
        leg=kernel.leg.operations(),
        platform=kernel.shared.operations() + shift,
        sum_c=Operations(add=sums),
        solve=solve + PIVOTS if product else solve,
        forces=Operations(add=LEGS if n.D in given else 0),
        moments=moments,
    )
