"""Operation counts of a whole kernel: six legs, platform, sum of c, solve, F = D - x.

Counts +, -, *, / and sqrt one each; negation, copies, comparisons and absolute values are free. Knows blocks
and the elimination that the emitters print, not their text.
"""

from dataclasses import dataclass

from .block import Operations
from .kernels import Kernel
from .reduce import share
from .regroup import ForceKernel

LEGS = 6


@dataclass(frozen=True)
class KernelOperations:
    """Counts of one pose of inverse dynamics, part by part."""

    leg: Operations
    platform: Operations
    sum_c: Operations
    solve: Operations
    forces: Operations

    @property
    def total(self) -> Operations:
        """Everything: six legs, the platform's part, the sum of c, the solve, F = D - x."""
        return LEGS * self.leg + self.platform + self.sum_c + self.solve + self.forces

    def parts(self) -> dict[str, Operations]:
        """The counts by name, the total last."""
        return {
            "leg": self.leg,
            "platform": self.platform,
            "sum of c": self.sum_c,
            "solve": self.solve,
            "forces": self.forces,
            "total": self.total,
        }


def elimination(size: int) -> Operations:
    """Gaussian elimination of ``size`` equations with one right side, reciprocal pivots."""
    below = size * (size - 1) // 2
    update = sum((size - i - 1) * (size - i - 1) for i in range(size))
    products = below + update + below + below + size
    return Operations(mul=products, add=update + 2 * below, div=size)


def kernel_operations(kernel: Kernel) -> KernelOperations:
    """Counts of a kernel as it is (share its blocks first to count what is emitted)."""
    return KernelOperations(
        leg=kernel.leg.operations(),
        platform=kernel.platform.operations(),
        sum_c=Operations(add=6 * LEGS),
        solve=elimination(LEGS),
        forces=Operations(add=LEGS),
    )


def force_operations(kernel: ForceKernel) -> KernelOperations:
    """Counts of a regrouped kernel after sharing; ``platform`` holds what the pose has for all legs."""
    return KernelOperations(
        leg=share(kernel.leg).operations(),
        platform=share(kernel.shared).operations(),
        sum_c=Operations(add=6 * LEGS),
        solve=elimination(LEGS),
        forces=Operations(add=LEGS),
    )
