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
        "model_numbers": 283,
        "operations": {
            "leg": 265, "platform": 192, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6,
            "total": 2106,
        },
    },
    "frictionless": {
        "kernel": "exact_frictionless",
        "meaning": "no friction",
        "universal": True,
        "model_numbers": 258,
        "operations": {
            "leg": 234, "platform": 186, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6,
            "total": 1896,
        },
    },
    "axisymmetric_friction": {
        "kernel": "exact_axisymmetric_friction",
        "meaning": "legs alike all round their axis, with friction",
        "universal": True,
        "model_numbers": 187,
        "operations": {
            "leg": 225, "platform": 192, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6,
            "total": 1866,
        },
    },
    "axisymmetric": {
        "kernel": "exact_axisymmetric",
        "meaning": "legs alike all round their axis",
        "universal": True,
        "model_numbers": 162,
        "operations": {
            "leg": 194, "platform": 186, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6,
            "total": 1656,
        },
    },
    "slender_friction": {
        "kernel": "exact_slender_friction",
        "meaning": "no inertia about the leg's axis, with friction",
        "universal": True,
        "model_numbers": 171,
        "operations": {
            "leg": 223, "platform": 192, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6,
            "total": 1854,
        },
    },
    "slender": {
        "kernel": "exact_slender",
        "meaning": "no inertia about the leg's axis",
        "universal": False,
        "model_numbers": 90,
        "operations": {
            "leg": 107, "platform": 186, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6,
            "total": 1134,
        },
    },
    "point_masses_friction": {
        "kernel": "exact_point_masses_friction",
        "meaning": "parts of the legs as points, with friction",
        "universal": True,
        "model_numbers": 171,
        "operations": {
            "leg": 223, "platform": 192, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6,
            "total": 1854,
        },
    },
    "point_masses": {
        "kernel": "exact_point_masses",
        "meaning": "parts of the legs as points",
        "universal": False,
        "model_numbers": 90,
        "operations": {
            "leg": 107, "platform": 186, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6,
            "total": 1134,
        },
    },
    "massless_friction": {
        "kernel": "exact_massless_friction",
        "meaning": "legs without mass, with friction",
        "universal": True,
        "model_numbers": 115,
        "operations": {
            "leg": 126, "platform": 186, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6,
            "total": 1266,
        },
    },
    "massless": {
        "kernel": "exact_massless",
        "meaning": "legs without mass, (41)",
        "universal": False,
        "model_numbers": 66,
        "operations": {
            "leg": 31, "platform": 180, "moments": 12, "sum of c": 0, "solve": 162, "forces": 0,
            "total": 588,
        },
    },
    "general_static": {
        "kernel": "exact_general_static",
        "meaning": "at rest",
        "universal": True,
        "model_numbers": 137,
        "operations": {
            "leg": 88, "platform": 75, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6,
            "total": 909,
        },
    },
    "slender_static": {
        "kernel": "exact_slender_static",
        "meaning": "at rest, centres of mass on the legs' axes",
        "universal": False,
        "model_numbers": 65,
        "operations": {
            "leg": 40, "platform": 75, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6,
            "total": 621,
        },
    },
    "massless_static": {
        "kernel": "exact_massless_static",
        "meaning": "at rest, legs without mass",
        "universal": False,
        "model_numbers": 57,
        "operations": {
            "leg": 31, "platform": 75, "moments": 12, "sum of c": 0, "solve": 162, "forces": 0,
            "total": 483,
        },
    },
}
