"""Least time along a path by CasADi with IPOPT, forces from the vector implementation."""

from collections.abc import Callable

import casadi
import numpy as np

from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.planning.path_parameterization import TimedPath
from stewart_sym.planning.timing.path_terms import Path, traveled
from stewart_sym.robot.robot import Robot

_NO_SPEED_LIMIT = 1e6


def graded(cells: int) -> np.ndarray:
    """Nodes from 0 to 1, denser toward the ends, where friction grows as the root of the way."""
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
        return inverse_dynamics(robot, traveled(motion, rate, second), backend="reference").F

    still, ahead, back = forces(0.0, 0.0), forces(1.0, 0.0), forces(-1.0, 0.0)
    return forces(0.0, 1.0) - still, 0.5 * (ahead + back) - still, 0.5 * (ahead - back), still


def solved(problem: dict, **bounds: object) -> tuple[float, np.ndarray]:
    """The optimum by IPOPT and where it is."""
    options = {"ipopt.print_level": 0, "print_time": False, "ipopt.tol": 1e-9, "ipopt.sb": "yes"}
    solve = casadi.nlpsol("oracle", "ipopt", problem, options | {"ipopt.max_iter": 1000})
    found = solve(**bounds)
    assert solve.stats()["success"], solve.stats()["return_status"]
    return float(found["f"]), np.array(found["x"])[:, 0]


class Cells:
    """Motions with s'' constant in each cell between nodes s, by their s' at the nodes."""

    def __init__(self, found: TimedPath, s: np.ndarray) -> None:
        """Of the machine and path of a motion."""
        self.robot, self.path, self.s, count = found.robot, found.path, s, len(s) - 1
        self.z = casadi.MX.sym("z", len(s))
        self.ends = (slice(0, count), slice(1, count + 1))
        h = casadi.DM(np.diff(s))
        self.second = (self.z[1:] ** 2 - self.z[:-1] ** 2) / (2.0 * h)
        self.duration = casadi.sum1(2.0 * h / (self.z[1:] + self.z[:-1]))
        self.most = np.full(len(s), _NO_SPEED_LIMIT)
        self.most[[0, -1]] = 0.0

    def forces(self, rows: slice, unit: np.ndarray | float) -> casadi.MX:
        """At an end of every cell, over a unit, (cells, 6)."""
        a, b, d, e = (casadi.DM(x / unit) for x in coefficients(self.robot, self.path, self.s[rows]))
        rate, second = (casadi.repmat(x, 1, 6) for x in (self.z[rows], self.second))
        return a * second + b * rate**2 + d * rate + e


def collocation_duration(found: TimedPath, cells: int) -> float:
    """Of the fastest motion, s: forces within limits at both ends of each cell."""
    motions = Cells(found, graded(cells))
    shares = [casadi.vec(motions.forces(rows, found.robot.force_limit)) for rows in motions.ends]
    problem = {"x": motions.z, "f": motions.duration, "g": casadi.vertcat(*shares)}
    x0 = begun(found, motions.s)
    return solved(problem, x0=x0, lbx=0.0, ubx=motions.most, lbg=-1.0, ubg=1.0)[0]
