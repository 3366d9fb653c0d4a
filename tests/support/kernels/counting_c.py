"""C that counts its own operations."""

import subprocess
from collections.abc import Mapping
from pathlib import Path
from string import Template

import numpy as np
from attack_build import rotor_flags

from stewart_sym.backend.kernel import MOTION, robot_numbers
from stewart_sym.motion.motion import Motion
from stewart_sym.robot.robot import Robot

COUNTING = r"""
#include <cstddef>
#include <cmath>
#include <cstdio>
struct Counts { long mul, add, div, sqrt; };
static Counts counts;
struct Real {
    double value;
    Real() : value(0) {}
    Real(double v) : value(v) {}
};
static Real operator+(Real a, Real b) { ++counts.add; return Real(a.value + b.value); }
static Real operator-(Real a, Real b) { ++counts.add; return Real(a.value - b.value); }
static Real operator*(Real a, Real b) { ++counts.mul; return Real(a.value * b.value); }
static Real operator/(Real a, Real b) { ++counts.div; return Real(a.value / b.value); }
static Real operator-(Real a) { return Real(-a.value); }
static bool operator>(Real a, Real b) { return a.value > b.value; }
static bool operator<(Real a, Real b) { return a.value < b.value; }
static bool operator>=(Real a, Real b) { return a.value >= b.value; }
static bool operator==(Real a, Real b) { return a.value == b.value; }
static bool operator!=(Real a, Real b) { return a.value != b.value; }
static bool operator<=(Real a, Real b) { return a.value <= b.value; }
static Real root(Real a) { ++counts.sqrt; return Real(std::sqrt(a.value)); }
/* Thresholds are constants times a scale: their products are not arithmetic of the equations. */
struct Threshold { Threshold() {} operator Real() const { return Real(1.8e-15); } };
static Real operator*(Threshold, Real b) { return Real(1.8e-15 * b.value); }
static bool operator>(Real a, Threshold) { return a.value > 1.8e-15; }
static Threshold operator*(Real, Threshold t) { return t; }
static bool operator>(Threshold, Threshold) { return false; }
static const Threshold threshold;
struct Ceiling { };
static Real operator*(Ceiling, Real b) { return Real(1e30 * b.value); }
static Real operator/(Threshold, Threshold) { return Real(1e-130); }
static Real operator*(Threshold, Threshold) { return Real(1e-130); }
#define STEWART_REAL Real
#define STEWART_SQRT(v) root(v)
#define STEWART_FABS(v) Real(std::fabs((v).value))
#define STEWART_EPSILON Threshold()
#define STEWART_MAX Real(1e308)
#define STEWART_SHORTEST Threshold()
#define STEWART_SUSPECT Threshold()
#define STEWART_SHORT_SHARE threshold
#define STEWART_BLOCK_GROWTH Ceiling()
#define STEWART_BLOCK_LEAST Threshold()
#define STEWART_BLOCK_SINGULAR Threshold()
${INCLUDES}
int main() {
    static stewart_robot robot;
    static stewart_motion motion;
    const double robot_numbers[] = {${ROBOT}};
    const double motion_numbers[] = {${MOTION}};
    for (size_t i = 0; i < sizeof robot / sizeof(Real); ++i) ((Real *)&robot)[i] = robot_numbers[i];
    for (size_t i = 0; i < sizeof motion / sizeof(Real); ++i) ((Real *)&motion)[i] = motion_numbers[i];
    ${CALL}
    return 0;
}
"""
REPORT = r"""
    std::printf("%d %ld %ld %ld %ld\n", status, counts.mul, counts.add, counts.div, counts.sqrt);"""


def listed(*values: object) -> str:
    """Numbers of arrays as C has them."""
    return ", ".join(repr(float(number)) for value in values for number in np.ravel(value))


def counted(
    texts: Mapping[str, str],
    includes: str,
    calls: str,
    robot: Robot,
    motion: Motion,
    folder: Path,
    kernel: str = "exact",
) -> list[tuple[int, tuple[int, ...]]]:
    """Status and (mul, add, div, sqrt) of each call that is reported, by the C's own arithmetic type.

    texts: the C by file name; kernel: for whose robots it is.
    """
    given = {
        "ROBOT": listed(robot_numbers(robot, kernel)),
        "MOTION": listed(*(getattr(motion, name) for name in MOTION)),
    }
    program = Template(COUNTING).substitute(given, INCLUDES=includes, CALL=calls)
    for name, text in {**texts, "count.cpp": program}.items():
        (folder / name).write_text(text)
    flags = rotor_flags(kernel)
    subprocess.run(["g++", "-O0", "-w", *flags, "count.cpp", "-o", "count"], check=True, cwd=folder)
    lines = subprocess.run(["./count"], check=True, capture_output=True, text=True, cwd=folder).stdout
    rows = [[int(word) for word in line.split()] for line in lines.splitlines()]
    return [(status, tuple(counts)) for status, *counts in rows]
