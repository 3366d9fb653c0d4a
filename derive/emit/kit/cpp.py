"""``stewart.hpp``: the functions of a kit as C++17 classes, in one header, without heap or exceptions.

One of the kit's texts. Takes what functions a kit holds and how C calls them; knows no equation. Adds nothing
to the C but types: statuses that must not be ignored, arrays of fixed length, constants prepared once.
"""

from collections.abc import Iterable, Sequence

from ..c import STATUS
from .functions import MODEL, NOTHING, ROBOT, Function
from .words import filled


def wrapper(functions: Sequence[Function], version: str) -> str:
    """``stewart.hpp`` of a kit that holds these functions; version: of the generator.

    A class for each model, robot function family and baked kernel, and ``forces_kernel``, ``motion_kernel``,
    ``reactions_kernel`` and ``kinematics_kernel`` as other names of those that do such things.
    Raises ValueError for a function that is not in ``METHODS``.
    """
    for function in functions:
        if function.stem not in METHODS:
            raise ValueError(f"functions: expected some of {', '.join(METHODS)}, got {function.stem!r}")
    classes: dict[str, list[Function]] = {}
    for function in functions:
        classes.setdefault(_class_name(function), []).append(function)
    parts = {
        "version": version,
        "includes": _lines(f'#include "{name}"' for name in dict.fromkeys(f.header for f in functions)),
        "statuses": _lines(f"    {name.lower()} = STEWART_{name}, // {text}" for name, _, text in STATUS),
        "texts": _lines(
            f'    case status::{name.lower()}:\n        return "{text}";' for name, _, text in STATUS
        ),
        "classes": "\n".join(_class(name, members) for name, members in classes.items()),
        "aliases": _lines(_aliases(classes)),
    }
    return filled(_WRAPPER, parts)


def _lines(texts: Iterable[str]) -> str:
    return "\n".join(texts)


def _class_name(function: Function) -> str:
    """Named after the kernel, so that two kits of one program may hold different kernels."""
    if function.subject == MODEL:
        return f"{_short(function.prefix)}_kernel"
    if function.subject == NOTHING and function.stem == "forces":
        return f"{_short(function.symbol).removesuffix(f'_{function.stem}')}_kernel"
    return f"{_short(function.header.removesuffix('.h'))}_functions"


def _short(name: str) -> str:
    return name.removeprefix("stewart_")


def _class(name: str, functions: Sequence[Function]) -> str:
    first = functions[0]
    frame = {ROBOT: _OF_ROBOT, MODEL: _OF_MODEL, NOTHING: _OF_NOTHING}[first.subject]
    methods = "\n".join(_method(function) for function in functions)
    return filled(frame, {"name": name, "prefix": first.prefix, "methods": methods})


def _method(function: Function) -> str:
    text = METHODS[function.stem]
    # Scalar kernels compute one pose at a time.
    if function.stem == "forces" and not function.header.endswith("_pose.h"):
        text += _BATCH
    checked, subject = {
        MODEL: (_PREPARED, "&model_, "),
        ROBOT: ("", "robot_, "),
        NOTHING: ("", ""),
    }[function.subject]
    return filled(text, {"symbol": function.symbol, "prepared": checked, "subject": subject})


def _aliases(classes: dict[str, list[Function]]) -> Iterable[str]:
    """The first class that has the first of these functions."""
    for alias, stems in _ALIASES.items():
        for name, functions in classes.items():
            if any(function.stem in stems for function in functions):
                yield f"using {alias} = {name};"
                break


_ALIASES = {
    "forces_kernel": ("forces",),
    "motion_kernel": (
        "equations",
        "bias",
        "forward_dynamics",
        "joint_inertia",
        "derivatives",
        "linearisation",
    ),
    "reactions_kernel": ("inverse_dynamics", "joint_reactions"),
    "kinematics_kernel": ("inverse_kinematics", "forward_kinematics", "forward_velocity"),
}

_PREPARED = """\
        if (prepared_ != status::ok) {
            return prepared_;
        }
"""


def _plain(says: str, name: str, parameters: str, arguments: str) -> str:
    """A method that hands its arguments on."""
    parameters = f"\n        {parameters}" if len(parameters) > 60 else parameters
    return f"""\
    // {says}
    [[nodiscard]] status {name}({parameters}) const noexcept
    {{
@prepared@        return static_cast<status>(@symbol@(@subject@{arguments}));
    }}
"""


METHODS = {
    "forces": _plain(
        "Actuator forces F, N, of a motion.",
        "operator()",
        "const stewart_motion &motion, out<6> F",
        "&motion, F.data()",
    ),
    "inverse_dynamics": _plain(
        "Actuator forces with their terms D, x, K, H and c.",
        "inverse_dynamics",
        "const stewart_motion &motion, stewart_forces &forces",
        "&motion, &forces",
    ),
    "joint_reactions": _plain(
        "Actuator forces and reactions in every joint; M_p about the base points.",
        "joint_reactions",
        "const stewart_motion &motion, stewart_forces &forces, stewart_reactions &reactions",
        "&motion, nullptr, &forces, &reactions",
    )
    + _plain(
        "The same; M_p at distances `bearing`, m, along each leg from its base point.",
        "joint_reactions",
        "const stewart_motion &motion, in<6> bearing, stewart_forces &forces, stewart_reactions &reactions",
        "&motion, bearing.data(), &forces, &reactions",
    ),
    "equations": _plain(
        "Closed form M [a; alpha] + C [v; omega] + g + friction = H F + load.",
        "equations",
        "const stewart_motion &motion, stewart_equations &found",
        "&motion, &found",
    ),
    "bias": _plain(
        "C [v; omega] + g + friction alone.",
        "bias",
        "const stewart_motion &motion, out<6> bias_wrench",
        "&motion, bias_wrench.data()",
    ),
    "forward_dynamics": _plain(
        "Accelerations [a; alpha] under actuator forces F, N.",
        "forward_dynamics",
        "const stewart_motion &motion, in<6> F, out<6> acceleration",
        "&motion, F.data(), acceleration.data()",
    ),
    "joint_inertia": _plain(
        "Inertia that the actuators feel, row-major.",
        "joint_inertia",
        "const stewart_motion &motion, out<36> inertia",
        "&motion, inertia.data()",
    ),
    "derivatives": _plain(
        "Actuator forces and their derivatives by pose, twist and acceleration.",
        "derivatives",
        "const stewart_motion &motion, stewart_derivatives &found",
        "&motion, &found",
    ),
    "linearisation": _plain(
        "Forward dynamics under forces F, N, and its linearisation.",
        "linearisation",
        "const stewart_motion &motion, in<6> F, stewart_linearisation &found",
        "&motion, F.data(), &found",
    ),
    "inverse_kinematics": _plain(
        "Lengths of the legs, m, and their rates, m/s.",
        "inverse_kinematics",
        "const stewart_motion &motion, out<6> L, out<6> L_dot",
        "&motion, L.data(), L_dot.data()",
    ),
    "forward_kinematics": _plain(
        "The pose with leg lengths L, m; `pose` holds the guess and takes what was found.",
        "forward_kinematics",
        "in<6> L, stewart_pose &pose",
        "L.data(), &pose",
    ),
    "forward_velocity": _plain(
        "Velocities at a pose from the rates of the legs, m/s.",
        "forward_velocity",
        "const stewart_pose &pose, in<6> L_dot, out<3> v, out<3> omega",
        "&pose, L_dot.data(), v.data(), omega.data()",
    ),
    "motion_from_rpy": _plain(
        "R, omega and alpha of `motion` from sines, cosines and rates of roll, pitch and yaw.",
        "from_rpy",
        "in<3> sine, in<3> cosine, in<3> theta_dot, in<3> theta_ddot, stewart_motion &motion",
        "sine.data(), cosine.data(), theta_dot.data(), theta_ddot.data(), &motion",
    ),
    "motion_from_quaternion": _plain(
        "The same from a quaternion of any length, scalar first, and its rates.",
        "from_quaternion",
        "in<4> e, in<4> e_dot, in<4> e_ddot, stewart_motion &motion",
        "e.data(), e_dot.data(), e_ddot.data(), &motion",
    ),
}
"""Methods of the functions by their stems."""

_BATCH = """
    // Forces [count][6] of `count` poses; `each` takes the codes of each. Returns the first that is not ok.
    [[nodiscard]] status batch(
        std::size_t count, const stewart_motions &motions, real *F, int *each = nullptr) const noexcept
    {
@prepared@        return static_cast<status>(@symbol@_batch(@subject@count, &motions, F, each));
    }
#if defined(STEWART_SPAN)
    // As many poses as there are codes in `each`; bad_argument unless F has six numbers for each.
    [[nodiscard]] status batch(
        const stewart_motions &motions, std::span<real> F, std::span<int> each) const noexcept
    {
        if (F.size() != 6 * each.size()) {
            return status::bad_argument;
        }
        return batch(each.size(), motions, F.data(), each.data());
    }
#endif
"""

_OF_MODEL = """\
#if !defined(STEWART_HPP_@name@)
#define STEWART_HPP_@name@
// A robot's constants, prepared by the constructor, and what is computed from them. Without a robot, or where
// one could not be prepared, every call returns that status and writes nothing.
class @name@ {
public:
    @name@() noexcept = default;
    explicit @name@(const stewart_robot &robot) noexcept
        : prepared_(static_cast<status>(@prefix@_prepare(&robot, &model_)))
    {
    }

    // Of the constructor.
    [[nodiscard]] status prepared() const noexcept { return prepared_; }
    [[nodiscard]] const @prefix@_model &model() const noexcept { return model_; }

@methods@
private:
    @prefix@_model model_{};
    status prepared_ = status::bad_argument;
};
#endif
"""

_OF_ROBOT = """\
#if !defined(STEWART_HPP_@name@)
#define STEWART_HPP_@name@
// What is computed from a robot's own constants, which must outlive this.
class @name@ {
public:
    explicit @name@(const stewart_robot &robot) noexcept : robot_(&robot) {}
    explicit @name@(const stewart_robot &&) = delete;

@methods@
private:
    const stewart_robot *robot_;
};
#endif
"""

_OF_NOTHING = """\
#if !defined(STEWART_HPP_@name@)
#define STEWART_HPP_@name@
// What takes no robot: its numbers are in the code, or none are needed.
class @name@ {
public:
@methods@};
#endif
"""

_WRAPPER = """\
// stewart.hpp: the functions of this kit for C++17 and later.
//
// Written by stewart-sym @version@; do not edit.
// SPDX-License-Identifier: 0BSD
//
// Only types around the C: no heap, no exceptions, no state but a robot's prepared constants. Any number of
// threads may call a const object at once. On a status other than ok the outputs are left as they were.
#ifndef STEWART_HPP
#define STEWART_HPP

#include <array>
#include <cstddef>

#include "stewart.h"

#if __cplusplus >= 202002L
#include <span>
#define STEWART_SPAN
#endif

namespace stewart {

using real = stewart_real;

// All are worth looking at: a function that returns one must not be called for nothing.
enum class [[nodiscard]] status : int {
@statuses@
};

[[nodiscard]] constexpr const char *text(status code) noexcept
{
    switch (code) {
@texts@
    }
    return "unknown status";
}

// N numbers to write to: of a std::array, of an array, or of a std::span of that length.
template <std::size_t N> class out {
public:
    constexpr out(std::array<real, N> &numbers) noexcept : data_(numbers.data()) {}
    constexpr out(real (&numbers)[N]) noexcept : data_(numbers) {}
#if defined(STEWART_SPAN)
    constexpr out(std::span<real, N> numbers) noexcept : data_(numbers.data()) {}
#endif
    [[nodiscard]] constexpr real *data() const noexcept { return data_; }

private:
    real *data_;
};

// N numbers to read.
template <std::size_t N> class in {
public:
    constexpr in(const std::array<real, N> &numbers) noexcept : data_(numbers.data()) {}
    constexpr in(const real (&numbers)[N]) noexcept : data_(numbers) {}
#if defined(STEWART_SPAN)
    constexpr in(std::span<const real, N> numbers) noexcept : data_(numbers.data()) {}
#endif
    [[nodiscard]] constexpr const real *data() const noexcept { return data_; }

private:
    const real *data_;
};

} // namespace stewart

#endif

// Of this kit; another kit's stewart.hpp may add its own.
@includes@

namespace stewart {

@classes@
@aliases@

} // namespace stewart
"""
