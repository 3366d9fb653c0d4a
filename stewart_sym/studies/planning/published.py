"""Tables of the documentation from ``plan.json``: planned paths, forces and condition numbers, Path III."""

import numpy as np

from ..common.output import Figures, paragraph, table


def tables(found: Figures) -> dict[str, str]:
    """Name -> Markdown."""
    return {
        "plan_gains": gains(found["gains"]),
        "plan_claim": claim(found["claim"]),
        "plan_path_III": path_III(found["path_III"]),
    }


def gains(found: Figures) -> str:
    """Planned over straight paths."""
    names = {
        "mean": "mean condition number",
        "peak": "peak condition number",
        "peak_force": "peak force in the same time",
        "length": "length",
    }
    rows = [
        (name, *(f"{value:.3f}" for value in np.quantile(found[key], [0.0, 0.25, 0.5, 0.75, 1.0])))
        for key, name in names.items()
    ]
    text = f"Planned over straight paths through six via poses of {found['machines']} random machines:"
    return paragraph(text) + table(("ratio", "least", "quarter", "median", "three quarters", "largest"), rows)


def claim(found: Figures) -> str:
    """Whether a higher condition number tells of higher forces."""
    header = ("motion", "median", "quarter", "three quarters", "above 0", "above 0.5", "of the peaks")
    rows = []
    for name, values in found["correlation"].items():
        low, middle, high = np.quantile(values, [0.25, 0.5, 0.75])
        shares = (f"{100.0 * np.mean(np.array(values) > bound):.0f} %" for bound in (0.0, 0.5))
        peaks = found["correlation_of_peaks"][name]
        rows.append((name, *(f"{value:.2f}" for value in (middle, low, high)), *shares, f"{peaks:.2f}"))
    text = (
        "Rank correlation of the condition number of H and the largest force of a leg along each of "
        f"{found['paths']} straight paths of random machines, and that of the peaks of all paths:"
    )
    return paragraph(text) + table(header, rows)


def path_III(found: Figures) -> str:
    """Path III before and after."""
    rows = []
    for name in ("straight", "planned"):
        peak = found["conditions"][name]["peak"]
        force = max(found["force_N"][name])
        rows.append(
            (
                name,
                str(found["crossings"][name]),
                "infinite" if peak is None else f"{peak:.0f}",
                f"{found['conditions'][name]['mean']:.0f}",
                "unbounded" if peak is None else f"{force:.0f}",
            )
        )
    text = (
        "The signs of det H at the ends of Path III are {:+.0f} and {:+.0f}: every path between them crosses "
        "a singular pose. With the end turned by {:.1f} degrees about the platform's own axis there is one "
        "that does not:"
    ).format(*found["signs_of_det_H"], np.degrees(found["yaw_rad"]))
    header = ("path", "crossings", "peak condition number", "mean", "peak force in 6 s, N")
    return paragraph(text) + table(header, rows)
