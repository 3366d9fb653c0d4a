"""The equations of one machine as CasADi functions, for optimizers such as IPOPT and acados.

Derives when it is called.
"""

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from ..backend.kernel import MOTION
from ..dynamics.inverse_dynamics import Formulation
from ..io.arguments import option, truth
from ..io.extras import needed_for
from ..robot.robot import Robot
from .symbols import prepared

if TYPE_CHECKING:
    import casadi

_RATES = ("R", "t", "omega", "v")
ARGUMENTS = {
    "forces": tuple(MOTION),
    "equations": _RATES,
    "forward_dynamics": (*_RATES, "F", "F_ext", "M_ext"),
}
"""Functions and what they take, in order."""


def casadi_function(
    robot: Robot, quantity: str = "forces", formulation: Formulation = "exact", checked: bool = True
) -> "casadi.Function":
    """Forces, equations of motion or forward dynamics of one machine as a CasADi function of SX.

    Parameters
    ----------
    robot : Robot
        The machine.
    quantity : str, optional
        "forces" of R (3, 3), t, omega, v, alpha, a, F_ext, M_ext (3,) gives F (6,), N; "equations" of R, t,
        omega, v gives M, C (6, 6), g, friction, bias (6,), H and its rate H_dot (6, 6); "forward_dynamics" of
        R, t, omega, v, F, F_ext, M_ext gives a and alpha (3,). Arguments and results have these names.
        `exact` with universal base joints has all three, `paper` and spherical joints the forces; none with
        offset joints.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.
    checked : bool, optional
        As in C, near a joint singularity the legs take a code path of their own, and a last result
        ``status``, a code of ``results.STATUS_TEXT``, is 0 or the others are NaN. Without, the function is a
        third as long: no status, and the digits that a leg loses near the fixed axis of its universal joint
        are lost.

    Returns
    -------
    casadi.Function
        Function with named arguments and results.

    Raises
    ------
    ValueError
        For other names and an unknown formulation, and MissingExtraError without CasADi.
    """
    option(quantity, tuple(ARGUMENTS), "quantity")
    truth(checked, "checked")
    with needed_for("a CasADi function"):
        import casadi
    from ..derive.kernel.tree.interpret import Interpreter

    program, _, model = prepared(robot, quantity, quantity, formulation)
    given = {name: casadi.SX.sym(name, 3, 3 if name == "R" else 1) for name in MOTION}
    # Components in storage order: CasADi's own is by columns.
    parts = {name: casadi.vertsplit(casadi.vec(value.T)) for name, value in given.items()}
    motion = SimpleNamespace(**parts)
    given["F"] = casadi.SX.sym("F", 6)
    more = [casadi.vertsplit(given["F"])] if quantity == "forward_dynamics" else []
    found = Interpreter(program, _arithmetic(checked)).run(quantity, model, motion, *more)
    results = {name: _matrix(value) for name, value in vars(found).items() if checked or name != "status"}
    names = ARGUMENTS[quantity]
    return casadi.Function(
        quantity, [given[name] for name in names], list(results.values()), list(names), list(results)
    )


def _matrix(value: Any) -> Any:
    import casadi

    rows = value if isinstance(value, list) else [value]
    return casadi.vertcat(*(casadi.horzcat(*row) if isinstance(row, list) else row for row in rows))


def _arithmetic(checked: bool) -> Any:
    import casadi

    from ..derive.kernel.tree.constants import constants
    from ..derive.kernel.tree.interpret import Arithmetic

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
