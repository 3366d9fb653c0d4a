"""Fidelity levels of the force kernels of ``exact``, from all terms to the platform only.

Written by stewart-sym 0.1.0.dev0 with SymPy 1.14; do not edit. Regenerate with ``stewart-sym derive``.
SPDX-License-Identifier: 0BSD
"""

from typing import Any

# kernel: name in C, stewart_<kernel>_forces; universal: True if it reads the axes of the universal joints.
FIDELITIES: dict[str, dict[str, Any]] = {
    "general": {
        "kernel": "exact",
        "meaning": "everything",
        "universal": True,
        "operations": {
            "leg": 265, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 2206,
        },
    },
    "frictionless": {
        "kernel": "exact_frictionless",
        "meaning": "no friction",
        "universal": True,
        "operations": {
            "leg": 234, "platform": 186, "moments": 21, "sum of c": 33, "solve": 262, "forces": 6,
            "total": 1996,
        },
    },
    "axisymmetric_friction": {
        "kernel": "exact_axisymmetric_friction",
        "meaning": "axisymmetric legs, with friction",
        "universal": True,
        "operations": {
            "leg": 225, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 1966,
        },
    },
    "axisymmetric": {
        "kernel": "exact_axisymmetric",
        "meaning": "axisymmetric legs",
        "universal": True,
        "operations": {
            "leg": 194, "platform": 186, "moments": 21, "sum of c": 33, "solve": 262, "forces": 6,
            "total": 1756,
        },
    },
    "slender_friction": {
        "kernel": "exact_slender_friction",
        "meaning": "no inertia about the leg's axis, with friction",
        "universal": True,
        "operations": {
            "leg": 223, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 1954,
        },
    },
    "slender": {
        "kernel": "exact_slender",
        "meaning": "no inertia about the leg's axis",
        "universal": False,
        "operations": {
            "leg": 107, "platform": 186, "moments": 21, "sum of c": 33, "solve": 262, "forces": 6,
            "total": 1234,
        },
    },
    "point_masses_friction": {
        "kernel": "exact_point_masses_friction",
        "meaning": "parts of the legs as points, with friction",
        "universal": True,
        "operations": {
            "leg": 223, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 1954,
        },
    },
    "point_masses": {
        "kernel": "exact_point_masses",
        "meaning": "parts of the legs as points",
        "universal": False,
        "operations": {
            "leg": 107, "platform": 186, "moments": 21, "sum of c": 33, "solve": 262, "forces": 6,
            "total": 1234,
        },
    },
    "massless_friction": {
        "kernel": "exact_massless_friction",
        "meaning": "legs without mass, with friction",
        "universal": True,
        "operations": {
            "leg": 126, "platform": 180, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 1360,
        },
    },
    "massless": {
        "kernel": "exact_massless",
        "meaning": "legs without mass, equation (41) of the paper",
        "universal": False,
        "operations": {
            "leg": 31, "platform": 174, "moments": 12, "sum of c": 0, "solve": 262, "forces": 0,
            "total": 682,
        },
    },
    "general_static": {
        "kernel": "exact_general_static",
        "meaning": "at rest",
        "universal": True,
        "operations": {
            "leg": 88, "platform": 72, "moments": 21, "sum of c": 33, "solve": 262, "forces": 6,
            "total": 1006,
        },
    },
    "slender_static": {
        "kernel": "exact_slender_static",
        "meaning": "at rest, centers of mass on the legs' axes",
        "universal": False,
        "operations": {
            "leg": 40, "platform": 72, "moments": 21, "sum of c": 33, "solve": 262, "forces": 6,
            "total": 718,
        },
    },
    "massless_static": {
        "kernel": "exact_massless_static",
        "meaning": "at rest, legs without mass",
        "universal": False,
        "operations": {
            "leg": 31, "platform": 72, "moments": 12, "sum of c": 0, "solve": 262, "forces": 0,
            "total": 580,
        },
    },
}

# Additional levels of legs with rotors; the other levels omit the rotors.
DRIVE_FIDELITIES: dict[str, dict[str, Any]] = {
    "general": {
        "kernel": "exact_drive",
        "meaning": "everything, rotors included",
        "universal": True,
        "operations": {
            "leg": 277, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 2278,
        },
    },
    "reflected": {
        "kernel": "exact_drive_reflected",
        "meaning": "rotors as masses that move with the lengths",
        "universal": True,
        "operations": {
            "leg": 267, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 2218,
        },
    },
    "reflected_slender_friction": {
        "kernel": "exact_drive_reflected_slender_friction",
        "meaning": "reflected masses, no inertia about the leg's axis, with friction",
        "universal": True,
        "operations": {
            "leg": 225, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 1966,
        },
    },
    "reflected_slender": {
        "kernel": "exact_drive_reflected_slender",
        "meaning": "reflected masses, no inertia about the leg's axis",
        "universal": False,
        "operations": {
            "leg": 116, "platform": 186, "moments": 21, "sum of c": 33, "solve": 262, "forces": 6,
            "total": 1288,
        },
    },
    "reflected_massless_friction": {
        "kernel": "exact_drive_reflected_massless_friction",
        "meaning": "reflected masses, legs without mass of their own, with friction",
        "universal": True,
        "operations": {
            "leg": 158, "platform": 192, "moments": 21, "sum of c": 51, "solve": 262, "forces": 6,
            "total": 1564,
        },
    },
    "reflected_massless": {
        "kernel": "exact_drive_reflected_massless",
        "meaning": "reflected masses, legs without mass of their own",
        "universal": False,
        "operations": {
            "leg": 81, "platform": 186, "moments": 12, "sum of c": 0, "solve": 262, "forces": 6,
            "total": 1000,
        },
    },
}
