"""Equations of one robot as CasADi functions, for optimizers such as IPOPT and acados.

The equations are derived on each call.
"""

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from ..backend.kernel import MOTION
from ..dynamics.inverse_dynamics import Formulation
from ..dynamics.leg_formulas import Functions, leg_motions, motor_torques
from ..io.arguments import instance, option, truth
from ..io.error_policy import need
from ..robot.offsets import need_no_offsets
from ..robot.robot import Robot, need_drive
from .symbols import prepared

if TYPE_CHECKING:
    import casadi

_RATES = ("R", "t", "omega", "v")
ARGUMENTS = {
    "forces": tuple(MOTION),
    "equations": _RATES,
    "forward_dynamics": (*_RATES, "F", "F_ext", "M_ext"),
    "lengths": _RATES[:2],
    "rates": _RATES,
    "torques": tuple(MOTION),
}
"""Functions and their arguments, in order."""


def casadi_function(
    robot: Robot, quantity: str = "forces", formulation: Formulation = "exact", checked: bool = True
) -> "casadi.Function":
    """Build a CasADi function (SX) of the kinematics, the dynamics, or the motor torques of one robot.

    Parameters
    ----------
    robot : Robot
        Robot model without offset joints.
    quantity : {"forces", "equations", "forward_dynamics", "lengths", "rates", "torques"}, optional
        Function to build; see Returns. "equations" and "forward_dynamics" require formulation "exact" and
        universal base joints.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.
    checked : bool, optional
        If True, the legs have a separate code path near a joint singularity, as in C. The last result is then
        ``status``, a code of ``results.STATUS_TEXT``; the other results are NaN if it is not 0. If False, the
        function is a third as long. It then has no status, and loses digits if a leg is near the fixed axis
        of its universal joint.

    Returns
    -------
    casadi.Function
        Function with these names of arguments and results, SI units, base frame except F_ext and M_ext
        (platform frame):

        - "forces": R (3, 3), t, omega, v, alpha, a, F_ext, M_ext (3,) to F (N) (6,).
        - "equations": R, t, omega, v to M, C (6, 6), g, friction, bias, bias_and_friction (6,), H, and its
          rate H_dot (6, 6).
        - "forward_dynamics": R, t, omega, v, F, F_ext, M_ext to a and alpha (3,).
        - "lengths": R, t to the leg lengths L (m) (6,).
        - "rates": R, t, omega, v to the leg rates L_dot (m/s) (6,).
        - "torques": the arguments of "forces" to the motor torques torque (N m) and F (N) (6,).

        "lengths" and "rates" have no status.

    Raises
    ------
    ValueError
        If the quantity or the formulation is unknown or not available for the robot.
    ImportError
        If CasADi is not installed.

    See Also
    --------
    symbolic : Derive SymPy formulas.
    ArrayKernel : Compute with JAX or PyTorch.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> forces = ss.casadi_function(ss.robots.load("unal"), "forces", checked=False)
    >>> forces.name_out()
    ['F']
    >>> zero = np.zeros(3)
    >>> F = forces(np.eye(3), [0.0, 0.0, 0.7], zero, zero, zero, zero, zero, zero)
    >>> F.full().ravel().round(2).tolist()
    [5.91, 5.91, 5.91, 5.91, 5.91, 5.91]
    """
    option(quantity, tuple(ARGUMENTS), "quantity")
    truth(checked, "checked")
    need("casadi", "a CasADi function")
    import casadi

    given = {name: casadi.SX.sym(name, 3, 3 if name == "R" else 1) for name in MOTION}
    given["F"] = casadi.SX.sym("F", 6)
    # CasADi stores columns, but the kernels read components row by row.
    parts = {name: casadi.vertsplit(casadi.vec(value.T)) for name, value in given.items()}
    found = _results(robot, quantity, formulation, checked, SimpleNamespace(**parts))
    results = {name: _matrix(value) for name, value in found.items() if checked or name != "status"}
    inputs = {name: given[name] for name in ARGUMENTS[quantity]}
    return casadi.Function(quantity, [*inputs.values()], [*results.values()], [*inputs], [*results])


def _results(
    robot: Robot, quantity: str, formulation: Formulation, checked: bool, motion: SimpleNamespace
) -> dict[str, Any]:
    """Return the results of a function by name; ``motion`` contains F for forward dynamics."""
    import casadi

    from ..derive.trace.interpret import Interpreter

    instance(robot, Robot, "robot")
    on = Functions(casadi.sqrt, casadi.fabs, casadi.exp, casadi.if_else)
    if quantity in ("lengths", "rates"):
        need_no_offsets(robot)
        name = {"lengths": "L", "rates": "L_dot"}[quantity]
        return {name: [getattr(leg, name) for leg in leg_motions(on, robot, motion)]}
    if quantity == "torques":
        need_drive(robot)
        found = _results(robot, "forces", formulation, checked, motion)
        return {"torque": motor_torques(on, robot, motion, found["F"]), **found}
    program, _, model = prepared(robot, quantity, quantity, formulation)
    more = [motion.F] if quantity == "forward_dynamics" else []
    return dict(vars(Interpreter(program, _arithmetic(checked)).run(quantity, model, motion, *more)))


def _matrix(value: Any) -> Any:
    import casadi

    rows = value if isinstance(value, list) else [value]
    return casadi.vertcat(*(casadi.horzcat(*row) if isinstance(row, list) else row for row in rows))


def _arithmetic(checked: bool) -> Any:
    import casadi

    from ..derive.trace.constants import constants
    from ..derive.trace.interpret import Arithmetic

    def where(test: Any, yes: Any, no: Any) -> Any:
        if isinstance(test, bool):
            return yes if test else no
        if not checked and isinstance(yes, int) and isinstance(no, int):
            return min(yes, no)
        return casadi.if_else(test, yes, no)

    return Arithmetic(
        number=casadi.SX,
        constants={"NAN": float("nan"), **constants("double")},
        sqrt=casadi.sqrt,
        size=casadi.fabs,
        larger=casadi.fmax,
        where=where,
        anywhere=lambda test: test if isinstance(test, bool) else checked,
        both=lambda one, other: one and other if isinstance(one, bool) else casadi.logic_and(one, other),
        either=lambda one, other: one or other if isinstance(one, bool) else casadi.logic_or(one, other),
    )
