"""Least time along a path by other programs: toppra without viscous friction, CasADi with IPOPT with it.

Both take the coefficients of forces from the vector implementation, `backend="reference"`.
"""

from collections.abc import Callable

import casadi
import numpy as np
import toppra
from toppra.constraint.linear_constraint import LinearConstraint, canlinear_colloc_to_interpolate

from stewart_sym.dynamics.inverse import inverse_dynamics
from stewart_sym.planning.time_path import TimedPath
from stewart_sym.planning.timing.path_terms import Path, travelled
from stewart_sym.robot.robot import Robot

_NO_SPEED_LIMIT = 1e6


def graded(cells: int) -> np.ndarray:
    """Nodes from 0 to 1, denser towards the ends, where friction grows as the root of the way."""
    return 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, cells + 1))


def begun(found: TimedPath, s: np.ndarray, share: float = 0.9) -> np.ndarray:
    """s' at nodes s from which a search begins: a share of those of a motion, none of them 0 between."""
    rate = share * np.interp(s, found.profile.nodes.s, found.profile.nodes.rate)
    rate[1:-1] += 1e-3
    return rate


def extrapolated(optimum: Callable[[int], float], cells: int) -> float:
    """An optimum by number of cells, s'' constant in each, without the error that halves with a cell."""
    return 2.0 * optimum(2 * cells) - optimum(cells)


def coefficients(robot: Robot, path: Path, s: np.ndarray) -> tuple[np.ndarray, ...]:
    """a, b, d, e of the forces a s'' + b s'^2 + d s' + e, (n, 6) each."""
    motion = path(s)

    def forces(rate: float, second: float) -> np.ndarray:
        return inverse_dynamics(robot, travelled(motion, rate, second), backend="reference").F

    still, ahead, back = forces(0.0, 0.0), forces(1.0, 0.0), forces(-1.0, 0.0)
    return forces(0.0, 1.0) - still, 0.5 * (ahead + back) - still, 0.5 * (ahead - back), still


def toppra_duration(robot: Robot, path: Path, limit: np.ndarray, cells: int) -> float:
    """Of the fastest motion without viscous friction, s; ``limit``: of the forces, N, (6,)."""
    s = graded(cells)
    line = toppra.SplineInterpolator([0.0, 0.5, 1.0], [[0.0], [0.5], [1.0]])
    solver = toppra.algorithm.TOPPRA(
        [_Forces(robot, path, limit)], line, gridpoints=s, solver_wrapper="seidel"
    )
    _, rate, _ = solver.compute_parameterization(0.0, 0.0)
    return float(np.sum(2.0 * np.diff(s) / (rate[1:] + rate[:-1])))


class _Forces(LinearConstraint):
    def __init__(self, robot: Robot, path: Path, limit: np.ndarray) -> None:
        super().__init__()
        self.robot, self.path, self.limit = robot, path, limit
        self.dof, self.identical = 1, True
        self.set_discretization_type(1)

    def compute_constraint_params(self, path: object, gridpoints: np.ndarray, *_: object) -> tuple:
        a, b, _, e = coefficients(self.robot, self.path, np.asarray(gridpoints))
        sides = np.concatenate([np.eye(6), -np.eye(6)])
        both = canlinear_colloc_to_interpolate(
            a, b, e, sides, np.tile(self.limit, 2), None, None, gridpoints, identical=True
        )
        return *both[:5], None, np.tile([0.0, _NO_SPEED_LIMIT], (len(gridpoints), 1))


def collocation_duration(found: TimedPath, cells: int) -> float:
    """Of the fastest motion with viscous friction, s: s'' constant in each cell, forces at both its ends."""
    robot, path, limit, s = found.robot, found.path, found.robot.force_limit, graded(cells)
    h = casadi.DM(np.diff(s))
    a, b, d, e = (casadi.DM(x / limit) for x in coefficients(robot, path, s))
    z = casadi.MX.sym("z", cells + 1)
    u = (z[1:] ** 2 - z[:-1] ** 2) / (2.0 * h)

    def shares(rows: slice) -> casadi.MX:
        rate, second = (casadi.repmat(x, 1, 6) for x in (z[rows], u))
        return a[rows, :] * second + b[rows, :] * rate**2 + d[rows, :] * rate + e[rows, :]

    ends = casadi.vertcat(casadi.vec(shares(slice(0, cells))), casadi.vec(shares(slice(1, cells + 1))))
    problem = {"x": z, "f": casadi.sum1(2.0 * h / (z[1:] + z[:-1])), "g": ends}
    options = {"ipopt.print_level": 0, "print_time": False, "ipopt.tol": 1e-9, "ipopt.sb": "yes"}
    solve = casadi.nlpsol("least_time", "ipopt", problem, options)
    highest = np.full(cells + 1, _NO_SPEED_LIMIT)
    highest[[0, -1]] = 0.0
    found = solve(x0=begun(found, s), lbx=np.zeros(cells + 1), ubx=highest, lbg=-1.0, ubg=1.0)
    assert solve.stats()["success"], solve.stats()["return_status"]
    return float(found["f"])
