"""Terms of the closed form and their sums: M, C, gravity, friction, bias, and derivatives of the wrench."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from ...program.block import Block, Quantity


def _matrix(name: str, unit: str, meaning: str, symmetric: bool = False) -> Quantity:
    return Quantity(name, (3, 3), unit, meaning, symmetric)


def _vector(name: str, unit: str, meaning: str) -> Quantity:
    return Quantity(name, (3,), unit, meaning)


def _wrench(name: str, meaning: str) -> tuple[Quantity, Quantity]:
    force = _vector(f"{name}_force", "N", f"{meaning}, force")
    return force, _vector(f"{name}_moment", "N m", f"{meaning}, moment")


# Inertia, rows and columns of v and omega.
M_VV = _matrix("M_vv", "kg", "inertia, force by a", True)
M_VW = _matrix("M_vw", "kg m", "inertia, force by alpha")
M_WW = _matrix("M_ww", "kg m^2", "inertia, moment by alpha", True)
INERTIA = (M_VV, M_VW, M_WW)

# Coriolis matrix, gravity, friction, bias, right side.
C_VV = _matrix("C_vv", "kg/s", "Coriolis matrix, force by v")
C_VW = _matrix("C_vw", "kg m/s", "Coriolis matrix, force by omega")
C_WV = _matrix("C_wv", "kg m/s", "Coriolis matrix, moment by v")
C_WW = _matrix("C_ww", "kg m^2/s", "Coriolis matrix, moment by omega")
CORIOLIS = (C_VV, C_VW, C_WV, C_WW)
GRAVITY = _wrench("g", "gravity")
FRICTION = _wrench("friction", "friction")
BIAS = _wrench("bias", "C twist + g + friction")
RIGHT = _wrench("right", "H F + external wrench - bias")

# Derivatives of the wrench M [a; alpha] + bias - external wrench - H F at fixed F.
BY_POSE = (
    _matrix("W_ft", "N/m", "force by dt"),
    _matrix("W_fr", "N", "force by dphi"),
    _matrix("W_mt", "N", "moment by dt"),
    _matrix("W_mr", "N m", "moment by dphi"),
)
BY_TWIST = (
    _matrix("W_fv", "N s/m", "force by v"),
    _matrix("W_fw", "N s", "force by omega"),
    _matrix("W_mv", "N s", "moment by v"),
    _matrix("W_mw", "N m s", "moment by omega"),
)

# Terms of the pose that the legs read.
B_0 = _matrix("B_0", "1/s^2", "[omega]x [omega]x")
F_LEG = Quantity("F", (), "N", "actuator force of the leg")
NET = Quantity(
    "net", (3,), "N, N m", "generalized forces of the leg less the actuator's, along L, theta, phi"
)
H_DOT = (
    _vector("H_dot_force", "1/s", "rate of the leg's column of H, force rows"),
    _vector("H_dot_moment", "m/s", "rate of the leg's column of H, moment rows"),
)

TURNED = Quantity(
    "turned",
    (3,),
    "m/s^2, 1/s^2",
    "accelerations of L, theta, phi caused by the platform's accelerations only",
)

AXIAL = Quantity(
    "axial", (), "1", "0 for a leg near its joint singularity with little inertia about its own axis, else 1"
)

# Inertia of a leg in its joint coordinates: M of (L, theta, phi), the gradients of
# L, theta, phi by the platform's position and rotation, generalized forces and their derivatives.
M_XI = _matrix("M_xi", "kg, kg m, kg m^2", "inertia of the joint coordinates, rows L, theta, phi", True)
ROWS = (
    _matrix("row_v", "1, 1/m", "gradients of L, theta, phi by position"),
    _matrix("row_w", "m, 1", "gradients of L, theta, phi by rotation"),
)
TAU = _vector("tau", "N, N m", "generalized forces less the actuator's without accelerations of the platform")
TAU_BY = tuple(
    _matrix(f"tau_{by}", "N, N m per unit", f"generalized forces by {meaning}, row for row")
    for by, meaning in (("t", "dt"), ("r", "dphi"), ("v", "v"), ("w", "omega"))
)


@dataclass(frozen=True)
class SumKernel:
    """Blocks of a pose and of one leg whose outputs are summed over the robot.

    The block of a leg also returns its column of H if required, and q, L, k3, by which the leg is checked.

    Attributes
    ----------
    name : str
        Name of the kernel.
    summed : tuple of Quantity
        Outputs of both blocks that are added.
    pose, leg : Block
        Block of the pose, and block of one leg.
    near : Block, optional
        Block of a leg for poses in which a leg is near its joint singularity, where ``leg`` is inaccurate.
    """

    name: str
    summed: tuple[Quantity, ...]
    pose: Block
    leg: Block
    near: Block | None = None

    def changed(self, change: Callable[[Block], Block]) -> "SumKernel":
        """Return the kernel with ``change`` applied to the blocks of a leg."""
        return replace(self, leg=change(self.leg), near=None if self.near is None else change(self.near))
