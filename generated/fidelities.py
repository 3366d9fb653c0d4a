"""The levels of fidelity of the force kernels of ``exact``, from everything to nothing but the platform.

Written by stewart-sym 0.1.0 with SymPy 1.14; do not edit. Regenerate with ``stewart-sym derive``.
"""

from typing import Any

# kernel: name of its C, stewart_<kernel>_forces; universal: whether it knows the universal joints' axes.
FIDELITIES: dict[str, dict[str, Any]] = {
    "general": {
        "kernel": "exact",
        "meaning": "everything",
        "universal": True,
        "model_numbers": 285,
        "operations": {"leg": 265, "platform": 195, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6, "total": 2109},
    },
    "frictionless": {
        "kernel": "exact_frictionless",
        "meaning": "no friction",
        "universal": True,
        "model_numbers": 260,
        "operations": {"leg": 234, "platform": 189, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6, "total": 1899},
    },
    "axisymmetric_friction": {
        "kernel": "exact_axisymmetric_friction",
        "meaning": "legs alike all round their axis, with friction",
        "universal": True,
        "model_numbers": 189,
        "operations": {"leg": 225, "platform": 195, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6, "total": 1869},
    },
    "axisymmetric": {
        "kernel": "exact_axisymmetric",
        "meaning": "legs alike all round their axis",
        "universal": True,
        "model_numbers": 164,
        "operations": {"leg": 194, "platform": 189, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6, "total": 1659},
    },
    "slender_friction": {
        "kernel": "exact_slender_friction",
        "meaning": "no inertia about the leg's axis, with friction",
        "universal": True,
        "model_numbers": 173,
        "operations": {"leg": 223, "platform": 195, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6, "total": 1857},
    },
    "slender": {
        "kernel": "exact_slender",
        "meaning": "no inertia about the leg's axis",
        "universal": False,
        "model_numbers": 92,
        "operations": {"leg": 107, "platform": 189, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6, "total": 1137},
    },
    "point_masses_friction": {
        "kernel": "exact_point_masses_friction",
        "meaning": "parts of the legs as points, with friction",
        "universal": True,
        "model_numbers": 173,
        "operations": {"leg": 223, "platform": 195, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6, "total": 1857},
    },
    "point_masses": {
        "kernel": "exact_point_masses",
        "meaning": "parts of the legs as points",
        "universal": False,
        "model_numbers": 92,
        "operations": {"leg": 107, "platform": 189, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6, "total": 1137},
    },
    "massless_friction": {
        "kernel": "exact_massless_friction",
        "meaning": "legs without mass, with friction",
        "universal": True,
        "model_numbers": 117,
        "operations": {"leg": 126, "platform": 189, "moments": 21, "sum of c": 51, "solve": 162, "forces": 6, "total": 1269},
    },
    "massless": {
        "kernel": "exact_massless",
        "meaning": "legs without mass, (41)",
        "universal": False,
        "model_numbers": 68,
        "operations": {"leg": 31, "platform": 183, "moments": 12, "sum of c": 0, "solve": 162, "forces": 0, "total": 591},
    },
    "general_static": {
        "kernel": "exact_general_static",
        "meaning": "at rest",
        "universal": True,
        "model_numbers": 139,
        "operations": {"leg": 88, "platform": 78, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6, "total": 912},
    },
    "slender_static": {
        "kernel": "exact_slender_static",
        "meaning": "at rest, centres of mass on the legs' axes",
        "universal": False,
        "model_numbers": 67,
        "operations": {"leg": 40, "platform": 78, "moments": 21, "sum of c": 33, "solve": 162, "forces": 6, "total": 624},
    },
    "massless_static": {
        "kernel": "exact_massless_static",
        "meaning": "at rest, legs without mass",
        "universal": False,
        "model_numbers": 59,
        "operations": {"leg": 31, "platform": 78, "moments": 12, "sum of c": 0, "solve": 162, "forces": 0, "total": 486},
    },
}
