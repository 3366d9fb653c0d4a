"""Columns of the regressor for the rotors of the legs' drives, besides those of the bodies.

    H F + [R F_ext; R M_ext] = Y pi + Y_r [m_r; j_r]

F is the motors' force along the legs.
"""

import numpy as np

from ..backend.numpy_kernel import legs_side_by_side, on_arrays
from ..dynamics.inverse import need_motion, need_universal, report_faults
from ..generated import rotor_regressor as generated
from ..io.arguments import option
from ..io.array_types import Array
from ..io.error_policy import ON_FAULT, OnFault
from ..motion.motion import Motion
from ..robot.robot import LEGS, Robot
from .parameters import evaluated


def rotor_regressor(robot: Robot, motion: Motion, on_singular: OnFault = "raise") -> Array:
    """Y_r, (..., 6, 12): columns of m_r of legs 1 to 6, then of j_r; formulation `exact`.

    Rows 0-2 are forces, N, rows 3-5 moments about the reference point, N m, base frame, each over the unit of
    its parameter, kg and kg m. Both parameters of a leg follow from J_r, its turns per length being known.

    Parameters
    ----------
    robot : Robot
        The machine, with a drive or without.
    motion : Motion
        Motion of the platform, any leading shape.
    on_singular : {"raise", "nan", "warn"}, optional
        As for ``regressor``.

    Returns
    -------
    ndarray
        Y_r, NaN where a pose has none.

    Raises
    ------
    ValueError
        For spherical base joints, for a motion without accelerations, and for poses in which a leg has length
        zero or lies along its universal axis.
    """
    need_universal(robot)
    need_motion(robot, motion)
    option(on_singular, ON_FAULT, "on_singular")
    _, status = evaluated(robot, motion, np.zeros(1, dtype=np.int32), "c")
    names = [f"{rows}_{name}" for name, _ in generated.PARAMETERS for rows in ("force", "moment")]

    def run(on: object, structure: object, part: object, _: slice) -> dict[str, Array]:
        leg = getattr(structure, "leg")  # noqa: B009
        return dict(vars(generated.rotor_columns(on, leg, structure, part)))  # type: ignore[arg-type]

    found, _ = on_arrays(run, legs_side_by_side(robot), motion, dict.fromkeys(names, (3, LEGS)))
    columns = [
        np.concatenate([found[f"force_{name}"], found[f"moment_{name}"]], axis=-2)
        for name, _ in generated.PARAMETERS
    ]
    Y = np.concatenate(columns, axis=-1)
    Y[status != 0] = np.nan
    report_faults(status, robot, motion, on_singular, stacklevel=3)
    return Y
