"""Motors' limits, jerk and motions of a given duration by CasADi with IPOPT.

Forces and rotors come from the vector implementation, friction of drives is written anew. Motors and peak
force: s'' constant in each cell of s. Jerk and energy: jerk of s constant in each step of time.
"""

import casadi
import numpy as np
from least_time_oracles import Cells, begun, coefficients, graded, solved
from scipy.optimize import brentq

from stewart_sym.dynamics.inverse_dynamics import inverse_dynamics
from stewart_sym.kinematics.inverse_kinematics import inverse_kinematics
from stewart_sym.planning.path_parameterization import TimedPath
from stewart_sym.planning.timing.path_terms import Path, traveled
from stewart_sym.reference.newton_euler import rotor_force
from stewart_sym.robot.robot import Robot


def _efforts(robot: Robot, path: Path, s: np.ndarray, side: np.ndarray):
    """N times torque, by branch of the efficiency, of s'' and s'; side: sign of L_dot, (n, 6)."""
    drive, motion = robot.drive, path(s)
    a, b, d, e = coefficients(robot, path, s)
    r_a, r_b = (rotor_force(robot, traveled(motion, rate, second)) for rate, second in ((0, 1), (1, 0)))
    rate = inverse_kinematics(robot, motion).L_dot
    n = 2.0 * np.pi / drive.lead
    viscous = drive.screw_viscous + n**2 * drive.motor_viscous
    dry = drive.screw_coulomb + np.abs(n) * drive.motor_coulomb

    def found(u: casadi.MX, z: casadi.MX) -> tuple[casadi.MX, casadi.MX]:
        u, z = casadi.repmat(u, 1, 6), casadi.repmat(z, 1, 6)
        rotor = casadi.DM(r_a) * u + casadi.DM(r_b) * z**2
        axial = casadi.DM(a - r_a) * u + casadi.DM(b - r_b) * z**2 + casadi.DM(d) * z + casadi.DM(e)
        speed = casadi.DM(np.abs(rate)) * z
        sign = casadi.DM(np.ones_like(rate))
        within = np.broadcast_to(drive.regularization_speed, rate.shape)
        if np.all(within > 0.0):
            x = casadi.fmin(speed / casadi.DM(within), 1.0)
            sign = 0.5 * x * (3.0 - x**2)
        slow = casadi.exp(-((speed / casadi.DM(np.broadcast_to(drive.stribeck_speed, rate.shape))) ** 2))
        loss = sign * (
            casadi.DM(np.broadcast_to(dry, rate.shape))
            + casadi.repmat(casadi.DM(drive.stribeck_force).T, len(s), 1) * slow
        )
        out = []
        for share in (1.0 / drive.efficiency - 1.0, drive.backdrive_efficiency - 1.0):
            slope = 1.0 + sign * casadi.repmat(casadi.DM(share).T, len(s), 1)
            out.append(
                casadi.DM(side) * (rotor + slope * axial)
                + loss
                + casadi.repmat(casadi.DM(viscous).T, len(s), 1) * speed
            )
        return out[0], out[1]

    return found


def motor_nodes(robot: Robot, path: Path, cells: int) -> np.ndarray:
    """Even nodes, more in both end cells, where friction grows as the root of s, and where legs turn back."""
    even = np.linspace(0.0, 1.0, cells + 1)
    more = even[2] * np.linspace(0.0, 1.0, 40) ** 3

    def rate(s: float, leg: int) -> float:
        return float(inverse_kinematics(robot, path(np.array([s]))).L_dot[0, leg])

    rates = inverse_kinematics(robot, path(even)).L_dot
    found = np.argwhere(rates[1:] * rates[:-1] < 0.0)
    turns = [brentq(rate, even[i], even[i + 1], args=(leg,), xtol=1e-14) for i, leg in found]
    apart = np.abs(even[:, None] - turns).min(axis=1, initial=1.0) > 1e-3 / cells
    return np.union1d(even[apart], [*more, *(1.0 - more), *turns])


def motor_duration(found: TimedPath, cells: int) -> float:
    """Least time within limits of force and of the motors, s."""
    robot, path, drive = found.robot, found.path, found.robot.drive
    motions = Cells(found, motor_nodes(robot, path, cells))
    s, z = motions.s, motions.z
    n = np.abs(2.0 * np.pi / drive.lead)
    torque = n * np.minimum(drive.torque_limit, drive.torque_constant * drive.current_limit)
    middle = np.sign(inverse_kinematics(robot, path(0.5 * (s[1:] + s[:-1]))).L_dot)
    rate = np.abs(inverse_kinematics(robot, path(s)).L_dot)
    g = []
    for rows in motions.ends:
        force = motions.forces(rows, robot.force_limit)
        p, q = _efforts(robot, path, s[rows], middle)(motions.second, z[rows])
        g += [force, -force]
        if np.isfinite(torque).all():
            scale = casadi.DM(np.broadcast_to(torque, middle.shape))
            g += [p / scale, q / scale, -q / scale]
        if np.isfinite(drive.power_limit).all():
            speed = casadi.DM(rate[rows] / drive.power_limit) * casadi.repmat(z[rows], 1, 6)
            g += [p * speed, q * speed, -q * speed]
    most = (drive.speed_limit / n / np.maximum(rate, 1e-300)).min(axis=1)
    problem = {"x": z, "f": motions.duration, "g": casadi.vertcat(*map(casadi.vec, g))}
    bounds = {"lbx": 0.0, "ubx": np.minimum(most, motions.most), "lbg": -casadi.inf, "ubg": 1.0}
    return solved(problem, x0=begun(found, s), **bounds)[0]


def peak_force(found: TimedPath, cells: int) -> float:
    """Least peak force of motions of the same duration, N."""
    motions, peak = Cells(found, graded(cells)), casadi.MX.sym("peak")
    limit = float(found.robot.force_limit.max())
    own = np.repeat(found.robot.force_limit / limit, cells)
    g = [motions.duration / found.duration - 1.0]
    for rows in motions.ends:
        force = casadi.vec(motions.forces(rows, limit))
        g += [force - peak, -force - peak, force - own, -force - own]
    problem = {"x": casadi.vertcat(motions.z, peak), "f": peak, "g": casadi.vertcat(*g)}
    x0, most = np.append(begun(found, motions.s, 1.0), 1.0), np.append(motions.most, 1e6)
    return limit * solved(problem, x0=x0, lbx=0.0, ubx=most, lbg=-casadi.inf, ubg=0.0)[0]


def smooth_optimum(
    robot: Robot, plan: TimedPath, steps: int, jerk: float | None = None, duration: float | None = None
) -> float:
    """Least time within limits of force and jerk, s; with a duration the work of the motion of least, J.

    plan: to begin from.
    """
    path, fine = plan.path, np.linspace(0.0, 1.0, 2001)
    legs = [inverse_kinematics(robot, path(np.clip(fine + h, 0.0, 1.0))) for h in (-1e-5, 0.0, 1e-5)]
    third = (legs[2].L_ddot - legs[0].L_ddot) / 2e-5
    third[[0, -1]] *= 2.0
    rows = np.concatenate([*coefficients(robot, path, fine), legs[1].L_dot, legs[1].L_ddot, third], axis=1)
    size = np.abs(rows).max(axis=0)
    size[size == 0.0] = 1.0
    table = casadi.interpolant("table", "bspline", [fine], (rows / size).ravel())
    state, time = casadi.MX.sym("state", 3, steps + 1), casadi.MX.sym("time")
    third_s = casadi.MX.sym("third", 1, steps)
    h = time / steps
    s, v, a = (state[i, :] for i in range(3))
    g = [
        s[1:] - s[:-1] - h * v[:-1] - h**2 / 2 * a[:-1] - h**3 / 6 * third_s,
        v[1:] - v[:-1] - h * a[:-1] - h**2 / 2 * third_s,
        a[1:] - a[:-1] - h * third_s,
    ]
    equal = 3 * steps
    s_half = s[:-1] + h / 2 * v[:-1] + h**2 / 8 * a[:-1] + h**3 / 48 * third_s
    v_half, a_half = v[:-1] + h / 2 * a[:-1] + h**2 / 8 * third_s, a[:-1] + h / 2 * third_s
    # Limits hold, and power is taken, in the middle of each step too.
    values = table.map(2 * steps + 1)(casadi.horzcat(s, s_half)) * casadi.DM(size)
    both = [casadi.horzcat(v, v_half), casadi.horzcat(a, a_half)]
    wide = [casadi.repmat(x, 6, 1) for x in both]
    force = (
        values[0:6, :] * wide[1]
        + values[6:12, :] * wide[0] ** 2
        + values[12:18, :] * wide[0]
        + values[18:24, :]
    )
    g.append(casadi.vec(force / casadi.DM(robot.force_limit)).T)
    one, two, three = values[24:30, :], values[30:36, :], values[36:42, :]
    if jerk is not None:
        for rows in (slice(0, steps), slice(1, steps + 1)):
            rate, second = (casadi.repmat(x[rows], 6, 1) for x in (v, a))
            each = (
                one[:, rows] * casadi.repmat(third_s, 6, 1)
                + 3.0 * two[:, rows] * rate * second
                + three[:, rows] * rate**3
            )
            g.append(casadi.vec(each / jerk).T)
    power = casadi.sum1(force * one * wide[0])
    simpson = np.concatenate([[1.0], np.full(steps - 1, 2.0), [1.0], np.full(steps, 4.0)]) / 6.0
    cost = time if duration is None else h * casadi.sum2(power * casadi.DM(simpson).T)
    x = casadi.vertcat(casadi.vec(state), casadi.vec(third_s), time)
    times = np.linspace(0.0, plan.duration, steps + 1)
    place = plan.profile.at(times)
    begin = np.stack([place.s, place.rate, place.second])
    x0 = np.concatenate([begin.T.ravel(), np.diff(place.second) / np.diff(times), [plan.duration]])
    low, high = np.full(len(x0), -1e9), np.full(len(x0), 1e9)
    low[: 3 * (steps + 1) : 3], high[: 3 * (steps + 1) : 3] = 0.0, 1.0
    low[1 : 3 * (steps + 1) : 3] = 0.0
    ends = [0, 1, 3 * steps, 3 * steps + 1] + ([2, 3 * steps + 2] if jerk is not None else [])
    for i in ends:
        low[i] = high[i] = 1.0 if i == 3 * steps else 0.0
    low[-1], high[-1] = (
        (duration, duration) if duration is not None else (1e-3 * plan.duration, 1e3 * plan.duration)
    )
    g = casadi.horzcat(*g)
    bound = np.ones(g.shape[1])
    bound[:equal] = 0.0
    scale = cost if duration is None else cost / float(np.abs(robot.force_limit).max())
    found, x = solved({"x": x, "f": scale, "g": g.T}, x0=x0, lbx=low, ubx=high, lbg=-bound, ubg=bound)
    return found if duration is None else _work(robot, path, x, steps, duration)


def _work(robot: Robot, path: Path, x: np.ndarray, steps: int, duration: float) -> float:
    """Work of the leg forces, J, by finer sums than those that IPOPT makes least."""
    (s, v, a), jerk = x[: 3 * (steps + 1)].reshape(-1, 3).T[..., None], x[3 * (steps + 1) : -1, None]
    h = duration / steps
    t = (np.arange(20) + 0.5) / 20 * h
    place = s[:-1] + v[:-1] * t + a[:-1] * t**2 / 2 + jerk * t**3 / 6
    rate, second = v[:-1] + a[:-1] * t + jerk * t**2 / 2, a[:-1] + jerk * t
    motion = traveled(path(np.clip(place, 0.0, 1.0).ravel()), rate.ravel(), second.ravel())
    F = inverse_dynamics(robot, motion, backend="reference").F
    return float(np.sum(F * inverse_kinematics(robot, motion).L_dot) * h / 20)
