"""The equations of one machine as SymPy expressions, their named steps kept.

Derives when it is called.
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

# SymPy's, which ships no types.
Matrix = Any
Symbol = Any
Expression = Any

FUNCTIONS = {
    "F": "forces",
    **dict.fromkeys(("D", "K", "H", "c"), "terms"),
    **dict.fromkeys(("M", "C", "g", "friction", "bias", "bias_and_friction"), "equations"),
    **dict.fromkeys(("a", "alpha"), "forward_dynamics"),
}
"""What there are formulas of, and the function of the kernel trees that computes it."""

_REQUIRED = ("R", "t", "F")
"""Arguments that have no value by default."""
_FOUND = ("alpha", "a")
"""What forward dynamics finds."""


@dataclass(frozen=True, eq=False)
class SymbolicResult:
    """A matrix of one machine as formulas.

    Attributes
    ----------
    name : str
        Of the matrix.
    result : Matrix
        In the symbols of arguments, constants and steps.
    steps : tuple
        (symbol, expression) in order, each in arguments, constants and earlier steps; those of leg 1 end in
        _1.
    constants : dict
        The machine's prepared numbers by symbol: sums and products of the robot's own, M_P and J_P with what
        of the legs moves as the platform does, unlike the inertial parameters of these names.
    arguments : dict
        R (3, 3), t, omega, v, alpha, a, F_ext, M_ext (3, 1); of forward dynamics F (6, 1), without alpha and
        a. Where a matrix does not depend on one, as H on omega, this has no effect.
    meanings : dict
        Unit and meaning of each, by its name without leg and axis.
    """

    name: str
    result: Matrix
    steps: tuple[tuple[Symbol, Expression], ...]
    constants: Mapping[Symbol, float]
    arguments: Mapping[str, Matrix]
    meanings: Mapping[str, tuple[str, str]]

    def substituted(self) -> Matrix:
        """The matrix in the arguments alone: numbers for the constants, every step substituted back.

        Expressions grow with every step: F takes half a minute, a and alpha longer. To print them or to
        compute with them keep the steps, as the other methods do.

        Returns
        -------
        Matrix
            Of the shape of ``result``.
        """
        known: dict[Any, Any] = dict(self.constants)
        for symbol, expr in self.steps:
            known[symbol] = expr.xreplace(known)
        return self.result.xreplace(known)

    def derivative(self, by: Symbol) -> "SymbolicResult":
        """The derivative by a component of an argument or by a constant.

        Parameters
        ----------
        by : Symbol
            One of ``arguments`` or ``constants``.

        Returns
        -------
        SymbolicResult
            Of the name ``d_...``; its steps are those of the matrix and their derivatives, named so too.

        Raises
        ------
        ValueError
            For anything else.
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
        """A NumPy function of one pose's arguments by name.

        It has no status: near a singularity digits are lost unnoticed, and ``prepare(robot).status(motion)``
        says where that is.

        Returns
        -------
        callable
            Its result is (3,), (6,), (6, 3) or (6, 6). R, t and F, where they are arguments, must be given;
            others are zero where not given. It raises ValueError for other names and shapes and for numbers
            that are not finite.
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
            for argument in _REQUIRED:
                if argument in self.arguments and argument not in given:
                    raise ValueError(f"{argument}: expected a value, got none")
            numbers = [
                np.zeros(len(of)) if argument not in given else _of_one_pose(argument, given[argument], of)
                for argument, of in self.arguments.items()
            ]
            return np.asarray(made(*np.concatenate(numbers)), dtype=np.float64).reshape(shape)

        return evaluated

    def latex(self) -> str:
        r"""The matrix with its steps, for a document with ``amsmath``.

        Returns
        -------
        str
            Steps that are the same for each leg but for its number stand there once, with the number i, and
            sums over the legs as one. The constants follow, with their units and meanings.
        """
        from .typesetting import typeset

        return typeset(self.name, self.result, self.steps, self.constants, self.meanings)


def symbolic(robot: Robot, quantity: str, formulation: Formulation = "exact") -> SymbolicResult:
    """One matrix of one machine's equations as formulas, with their steps.

    Parameters
    ----------
    robot : Robot
        The machine.
    quantity : str
        "F", "D", "K", "H" or "c" of (21), (24), (36), (37); "M", "C", "g", "friction", "bias", or
        "bias_and_friction" of the equations of motion; "a" or "alpha" of forward dynamics. The last two
        groups are of `exact` with universal base joints. The formulas are those of a regular pose: no leg
        near the fixed axis of its universal joint, status 0, and no exchange of rows in the solves for F, a
        and alpha, so that F has a zero divisor where a leading minor of H vanishes.
    formulation : {"exact", "paper"}, optional
        The corrected equations or those printed.

    Returns
    -------
    SymbolicResult
        Matrix, steps, constants and arguments.

    Raises
    ------
    ValueError
        For other names and an unknown formulation.
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
    arguments = {name: given[name] for name in given if "F" not in given or name not in _FOUND}
    return SymbolicResult(quantity, result, steps, constants, arguments, meanings)


def _of_one_pose(name: str, value: Any, symbols: Matrix) -> NDArray[np.float64]:
    """The numbers of an argument; ValueError that names it for other shapes and what is not finite."""
    shape = symbols.shape if symbols.shape[1] > 1 else symbols.shape[:1]
    return finite_array(value, shape, f"{name} of one pose", batch=False).ravel()


def prepared(
    robot: Robot, what: str, function: str, formulation: Formulation
) -> tuple[Any, str, SimpleNamespace]:
    """A function's tree, its name, and what is its first argument: constants prepared, or the robot's own.

    what: the user's word for the function.
    """
    from ..derive.kernel.tree.constants import constants
    from ..derive.kernel.tree.interpret import Arithmetic, Interpreter
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
        raise overflows(robot, "double")
    return program, function, model


@cache
def _program(name: str, function: str) -> Any:
    from ..derive.generate import output_program, reduced
    from ..derive.kernel.inverse_dynamics import terms_program
    from ..derive.mechanics.formulation import BY_KERNEL

    form = BY_KERNEL[name]
    if function == "terms":
        return terms_program(reduced(form))
    return output_program(form, (function,), by_pivots=True)


def _chained(expr: Expression, derivatives: Mapping[Any, Any]) -> Expression:
    import sympy as sp

    return sp.Add(
        *(expr.diff(symbol) * derivatives[symbol] for symbol in expr.free_symbols & derivatives.keys())
    )
