"""The levels of fidelity of the force kernels of ``exact``, from everything to nothing but the platform.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit. Regenerate with ``stewart-sym derive``.
SPDX-License-Identifier: 0BSD
"""

from typing import Any

# kernel: name of its C, stewart_<kernel>_forces; universal: whether it knows the universal joints' axes.
FIDELITIES: dict[str, dict[str, Any]] = {
    "general": {
        "kernel": "exact",
        "meaning": "everything",
        "universal": True,
        "model_numbers": 284,
        "operations": {"leg": 287, "platform": 195, "sum of c": 36, "solve": 157, "forces": 6, "total": 2116},
    },
    "frictionless": {
        "kernel": "exact_frictionless",
        "meaning": "no friction",
        "universal": True,
        "model_numbers": 259,
        "operations": {"leg": 252, "platform": 189, "sum of c": 36, "solve": 157, "forces": 6, "total": 1900},
    },
    "axisymmetric_friction": {
        "kernel": "exact_axisymmetric_friction",
        "meaning": "legs alike all round their axis, with friction",
        "universal": True,
        "model_numbers": 188,
        "operations": {"leg": 247, "platform": 195, "sum of c": 36, "solve": 157, "forces": 6, "total": 1876},
    },
    "axisymmetric": {
        "kernel": "exact_axisymmetric",
        "meaning": "legs alike all round their axis",
        "universal": True,
        "model_numbers": 163,
        "operations": {"leg": 212, "platform": 189, "sum of c": 36, "solve": 157, "forces": 6, "total": 1660},
    },
    "slender_friction": {
        "kernel": "exact_slender_friction",
        "meaning": "no inertia about the leg's axis, with friction",
        "universal": True,
        "model_numbers": 172,
        "operations": {"leg": 245, "platform": 195, "sum of c": 36, "solve": 157, "forces": 6, "total": 1864},
    },
    "slender": {
        "kernel": "exact_slender",
        "meaning": "no inertia about the leg's axis",
        "universal": False,
        "model_numbers": 91,
        "operations": {"leg": 125, "platform": 189, "sum of c": 36, "solve": 157, "forces": 6, "total": 1138},
    },
    "point_masses_friction": {
        "kernel": "exact_point_masses_friction",
        "meaning": "parts of the legs as points, with friction",
        "universal": True,
        "model_numbers": 172,
        "operations": {"leg": 245, "platform": 195, "sum of c": 36, "solve": 157, "forces": 6, "total": 1864},
    },
    "point_masses": {
        "kernel": "exact_point_masses",
        "meaning": "parts of the legs as points",
        "universal": False,
        "model_numbers": 91,
        "operations": {"leg": 125, "platform": 189, "sum of c": 36, "solve": 157, "forces": 6, "total": 1138},
    },
    "massless_friction": {
        "kernel": "exact_massless_friction",
        "meaning": "legs without mass, with friction",
        "universal": True,
        "model_numbers": 116,
        "operations": {"leg": 148, "platform": 189, "sum of c": 36, "solve": 157, "forces": 6, "total": 1276},
    },
    "massless": {
        "kernel": "exact_massless",
        "meaning": "legs without mass, (41)",
        "universal": False,
        "model_numbers": 67,
        "operations": {"leg": 40, "platform": 183, "sum of c": 0, "solve": 157, "forces": 0, "total": 580},
    },
    "general_static": {
        "kernel": "exact_general_static",
        "meaning": "at rest",
        "universal": True,
        "model_numbers": 138,
        "operations": {"leg": 106, "platform": 78, "sum of c": 36, "solve": 157, "forces": 6, "total": 913},
    },
    "slender_static": {
        "kernel": "exact_slender_static",
        "meaning": "at rest, centres of mass on the legs' axes",
        "universal": False,
        "model_numbers": 66,
        "operations": {"leg": 58, "platform": 78, "sum of c": 36, "solve": 157, "forces": 6, "total": 625},
    },
    "massless_static": {
        "kernel": "exact_massless_static",
        "meaning": "at rest, legs without mass",
        "universal": False,
        "model_numbers": 58,
        "operations": {"leg": 40, "platform": 78, "sum of c": 0, "solve": 157, "forces": 0, "total": 475},
    },
}
