"""Equations of one robot as SymPy expressions with named steps.

The equations are derived on each call.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..backend.kernel import overflows, robot_kernel
from ..dynamics.inverse_dynamics import Formulation
from ..io.arguments import finite_array, instance, option, shown
from ..results import OK
from ..robot.robot import Robot

# SymPy has no type stubs.
Matrix = Any
Symbol = Any
Expression = Any

FUNCTIONS = {
    "F": "forces",
    **dict.fromkeys(("D", "K", "H", "c"), "terms"),
    **dict.fromkeys(("M", "C", "g", "friction", "bias", "bias_and_friction"), "equations"),
    **dict.fromkeys(("a", "alpha"), "forward_dynamics"),
}
"""Quantities with formulas, and the function of the kernel trees that computes each."""

_REQUIRED = ("R", "t", "F")
"""Arguments without a default value."""


@dataclass(frozen=True, eq=False)
class SymbolicResult:
    """Matrix of one robot as formulas with named steps.

    Attributes
    ----------
    name : str
        Name of the matrix.
    result : Matrix
        Matrix in the symbols of arguments, constants, and steps.
    steps : tuple of (Symbol, Expression)
        Steps in order, each in terms of arguments, constants, and earlier steps. Names of leg 1 end in _1.
    constants : dict of float
        Prepared numbers of the robot by symbol: sums and products of its own numbers. M_P and J_P include the
        parts of the legs that move with the platform, unlike the inertial parameters of these names.
    arguments : dict of Matrix
        R (3, 3); t, omega, v, alpha, a, F_ext, M_ext (3, 1). Forward dynamics has F (6, 1) instead of alpha
        and a. Arguments on which a matrix does not depend, such as omega for H, have no effect.
    meanings : dict of tuple
        Unit and meaning of each constant, by its name without leg and axis.
    """

    name: str
    result: Matrix
    steps: tuple[tuple[Symbol, Expression], ...]
    constants: Mapping[Symbol, float]
    arguments: Mapping[str, Matrix]
    meanings: Mapping[str, tuple[str, str]]

    def substituted(self) -> Matrix:
        """Replace all steps and constants, so that the matrix depends only on the arguments.

        Expressions grow with every step: F takes half a minute, a and alpha longer. The other methods keep
        the steps and are better for printing and computing.

        Returns
        -------
        Matrix
            Matrix with the shape of ``result``.
        """
        known: dict[Any, Any] = dict(self.constants)
        for symbol, expr in self.steps:
            known[symbol] = expr.xreplace(known)
        return self.result.xreplace(known)

    def derivative(self, by: Symbol) -> "SymbolicResult":
        """Differentiate the matrix with respect to a component of an argument or a constant.

        Parameters
        ----------
        by : Symbol
            One of ``arguments`` or ``constants``.

        Returns
        -------
        SymbolicResult
            Derivative with the name ``d_...``. Its steps are the steps of the matrix and their derivatives,
            which also have names ``d_...``.

        Raises
        ------
        ValueError
            If ``by`` is not such a symbol.
        """
        import sympy as sp

        arguments = (symbol for given in self.arguments.values() for symbol in given)
        if not isinstance(by, sp.Symbol) or by not in {*arguments, *self.constants}:
            expected = "a symbol of the arguments or the constants"
            raise ValueError(f"by: expected {expected}, got {shown(by)}")
        derivatives: dict[Any, Any] = {by: sp.Integer(1)}
        steps = []
        for symbol, expr in self.steps:
            steps.append((symbol, expr))
            if derivative := _chained(expr, derivatives):
                derivatives[symbol] = sp.Symbol(f"d_{symbol.name}", real=True)
                steps.append((derivatives[symbol], derivative))
        result = self.result.applyfunc(lambda expr: _chained(expr, derivatives))
        return replace(self, name=f"d_{self.name}", result=result, steps=tuple(steps))

    def function(self) -> Callable[..., NDArray[np.float64]]:
        """Compile a NumPy function of the arguments, by name, for one pose.

        The function has no status: digits are lost near a singularity without notice.
        ``ForceKernel(robot).forces_and_status(motion)`` identifies such poses.

        Returns
        -------
        callable
            Function whose result has the shape (3,), (6,), (6, 3), or (6, 6). R, t, and F are required if
            they are arguments; others are zero by default. It raises ValueError for other names and shapes
            and for numbers that are not finite.
        """
        import sympy as sp

        constants = dict(self.constants)
        steps = [(symbol, expr.xreplace(constants)) for symbol, expr in self.steps]
        result = self.result.xreplace(constants)
        flat = [symbol for given in self.arguments.values() for symbol in given]
        made = sp.lambdify(flat, result, "numpy", cse=lambda exprs: (steps, exprs))
        shape = result.shape if result.shape[1] > 1 else (result.shape[0],)

        def evaluated(**given: Any) -> NDArray[np.float64]:
            for argument in given:
                option(argument, tuple(self.arguments), "argument")
            numbers = []
            for argument, symbols in self.arguments.items():
                if argument in _REQUIRED and argument not in given:
                    raise ValueError(f"{argument}: expected a value, got none")
                core = symbols.shape if symbols.shape[1] > 1 else symbols.shape[:1]
                value = given.get(argument, np.zeros(core))
                numbers.append(finite_array(value, core, f"{argument} of one pose", batch=False).ravel())
            return np.asarray(made(*np.concatenate(numbers)), dtype=np.float64).reshape(shape)

        return evaluated

    def latex(self) -> str:
        r"""Write the matrix with its steps as LaTeX, for a document with ``amsmath``.

        Returns
        -------
        str
            Steps that differ only in the number of the leg are written once, with the index i, and sums over
            the legs are one sum. The constants follow, with their units and meanings.
        """
        from .typesetting import typeset

        return typeset(self.name, self.result, self.steps, self.constants, self.meanings)


def symbolic(robot: Robot, quantity: str, formulation: Formulation = "exact") -> SymbolicResult:
    """Derive a matrix of the equations of one robot as formulas with named steps.

    Parameters
    ----------
    robot : Robot
        Robot model without offset joints.
    quantity : str
        "F", "D", "K", "H", or "c" of inverse dynamics; "M", "C", "g", "friction", "bias", or
        "bias_and_friction" of the equations of motion; "a" or "alpha" of forward dynamics. The last two
        groups require formulation "exact" and universal base joints.
    formulation : {"exact", "paper"}, optional
        "exact" for the corrected equations, "paper" for the equations as printed.

    Returns
    -------
    SymbolicResult
        SymPy matrix ``result`` with its ``steps``, ``constants``, and ``arguments``; it converts to NumPy
        functions and LaTeX. SI units, base frame.

    Raises
    ------
    ValueError
        If the quantity or the formulation is unknown or not available for the robot.

    See Also
    --------
    casadi_function : Build a CasADi function.
    inverse_dynamics : Compute the numbers.
    equations_of_motion : Compute the numbers of M, C, g, and friction.

    Notes
    -----
    F is (37), D is (24), K is (21), and H and c are (36) of Dasgupta and Mruthyunjaya, Mechanism and Machine
    Theory 33 (1998). The formulas are valid for regular poses: no leg near the fixed axis of its universal
    joint, and status 0. The solves for F, a, and alpha do not exchange rows, so that F has a zero divisor if
    a leading minor of H vanishes. The derivation takes seconds at the first call.

    Examples
    --------
    >>> import numpy as np
    >>> import stewart_sym as ss
    >>> formula = ss.symbolic(ss.robots.load("unal"), "F")
    >>> formula.result.shape
    (6, 1)
    >>> forces = formula.function()
    >>> forces(R=np.eye(3), t=[0.0, 0.0, 0.7]).round(2).tolist()
    [5.91, 5.91, 5.91, 5.91, 5.91, 5.91]
    """
    option(quantity, tuple(FUNCTIONS), "quantity")
    from ..derive.kernel.trace import described, needed, renamed, trace

    found = trace(*prepared(robot, quantity, FUNCTIONS[quantity], formulation))
    steps = needed(found.steps, found.results[quantity])
    names = renamed(steps)
    steps = tuple((symbol.xreplace(names), expr.xreplace(names)) for symbol, expr in steps)
    result = found.results[quantity].xreplace(names)
    used = set().union(result.free_symbols, *(expr.free_symbols for _, expr in steps))
    constants = {symbol: value for symbol, value in found.constants.items() if symbol in used}
    meanings = described(symbol.name for symbol in constants)
    given = found.arguments
    arguments = {name: given[name] for name in given if "F" not in given or name not in ("alpha", "a")}
    return SymbolicResult(quantity, result, steps, constants, arguments, meanings)


def prepared(
    robot: Robot, what: str, function: str, formulation: Formulation
) -> tuple[Any, str, SimpleNamespace]:
    """Return a function's tree, its name, and its first argument: prepared constants, or the robot's numbers.

    ``what`` is the name of the function in messages.
    """
    from ..derive.trace.constants import constants
    from ..derive.trace.interpret import Arithmetic, Interpreter
    from .trees import robot_structure

    instance(robot, Robot, "robot")
    name = robot_kernel(robot, formulation)
    if name not in ("exact", "exact_drive") and function in ("equations", "forward_dynamics"):
        raise ValueError(
            f'{what}: expected formulation "exact" and universal base joints, '
            f'got "{formulation}" and {robot.base_joint} ones'
        )
    program = _program(name, function)
    numbers = robot_structure(robot, lambda _, value: np.float64(value))
    if function == "terms":
        return program, function, numbers
    on = Arithmetic(np.float64, constants("double"), np.sqrt)
    with np.errstate(all="ignore"):
        model = Interpreter(program, on).run("prepare", numbers)
    if model.status != OK:
        raise overflows("double")
    return program, function, model


@cache
def _program(name: str, function: str) -> Any:
    from ..derive.generated_files import output_program, reduced
    from ..derive.kernel.inverse_dynamics import terms_program
    from ..derive.mechanics.formulation import BY_KERNEL

    form = BY_KERNEL[name]
    if function == "terms":
        return terms_program(reduced(form))
    return output_program(form, (function,), by_pivots=True)


def _chained(expr: Expression, derivatives: Mapping[Any, Any]) -> Expression:
    import sympy as sp

    symbols = expr.free_symbols & derivatives.keys()
    return sp.Add(*(expr.diff(symbol) * derivatives[symbol] for symbol in symbols))
