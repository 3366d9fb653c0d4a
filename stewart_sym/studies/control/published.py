"""Tables of the documentation from ``control.json``: tracking errors by the model in the controller."""

from typing import Any

from ..common.output import Figures, paragraph, table
from .control import Settings
from .report import NAMES, vector


def tables(found: Figures) -> dict[str, str]:
    """Name -> Markdown."""
    printed, friction = (by_name(found["machines"][label]["rows"]) for label in ("printed", "friction"))
    parts = [
        conditions(found["settings"]),
        figures(found["machines"]["printed"]["rows"]),
        legs(printed),
        faults(printed),
        with_friction(found["machines"]["friction"]["friction"], friction),
    ]
    return {"control": "".join(parts)}


def by_name(rows: list[Figures]) -> dict[tuple[str, str], Figures]:
    """Rows by path and controller."""
    return {(row["path"], row["controller"]): row for row in rows}


def conditions(given: dict[str, Any]) -> str:
    """What is compared."""
    settings = Settings(**given)
    t, phi = (vector(offset) for offset in (settings.offset_t, settings.offset_phi))
    return paragraph(
        "`stewart-sym control` tracks the paper's Paths I and II with controllers that differ only in "
        "their model of the machine: computed torque by `exact`, by `paper` and by the platform alone "
        "(massless legs, (41)), and PD with gravity compensation of the whole machine. The plant is `exact`; "
        f"forces are held at {settings.rate:g} Hz; k_p = {settings.k_p:g} 1/s^2, k_d = {settings.k_d:g} 1/s; "
        f"the start is off the path by {t} mm and {phi} mrad. Ratios are to `exact`, of RMS errors and of "
        "peak forces:"
    )


def figures(rows: list[Figures]) -> str:
    """Errors and forces of every controller."""
    header = (
        *("path", "model", "position RMS, mm", "max", "ratio", "orientation RMS, mrad", "max", "ratio"),
        *("peak force, N", "RMS", "ratio"),
    )
    cells = [
        (
            f"Path {row['path']}",
            NAMES[row["controller"]],
            *(
                cell
                for kind, unit in (("position", "mm"), ("orientation", "mrad"))
                for cell in (
                    f"{row[f'{kind}_rms_{unit}']:.3g}",
                    f"{row[f'{kind}_max_{unit}']:.3g}",
                    ratio(row, f"{kind}_rms_{unit}"),
                )
            ),
            f"{row['force_peak_N']:.0f}",
            f"{row['force_rms_N']:.0f}",
            f"{row['force_peak_N_to_exact']:.3f}",
        )
        for row in rows
    ]
    return table(header, cells)


def legs(rows: dict[tuple[str, str], Figures]) -> str:
    """What the legs in the model gain."""
    slow, fast = rows["I", "massless"], rows["II", "massless"]
    slow_pd, fast_pd = rows["I", "gravity"], rows["II", "gravity"]
    return paragraph(
        "The legs' share: without them in the model the platform is "
        f"{slow['position_rms_mm']:.3g} mm and {slow['orientation_rms_mrad']:.3g} mrad off on Path I, "
        f"{fast['position_rms_mm']:.3g} mm and {fast['orientation_rms_mrad']:.3g} mrad on Path II: "
        f"{ratio(slow, 'position_rms_mm')} and {ratio(fast, 'position_rms_mm')} times the position error of "
        f"`exact`, at {slow['force_peak_N_to_exact']:.2f} and {fast['force_peak_N_to_exact']:.2f} times its "
        "peak force. On Path I that is their weight: the whole machine's gravity and no inertia at all keeps "
        f"to {slow_pd['position_rms_mm']:.3g} mm there. On Path II, the same line in a tenth of the time, it "
        f"is {fast_pd['position_rms_mm']:.3g} mm off, {ratio(fast_pd, 'position_rms_mm')} times as far as "
        "`exact`."
    )


def faults(rows: dict[tuple[str, str], Figures]) -> str:
    """What the faults of the printed equations cost."""
    slow, fast = rows["I", "paper"], rows["II", "paper"]
    settled = "position_settled_rms_mm"
    return paragraph(
        f"The share of the printed equations' faults: `paper` errs {ratio(slow, 'position_rms_mm')} and "
        f"{ratio(fast, 'position_rms_mm')} times as much as `exact` in position, "
        f"{ratio(slow, 'orientation_rms_mrad')} and {ratio(fast, 'orientation_rms_mrad')} times in "
        f"orientation, by {slow['orientation_rms_mrad']:.3g} and {fast['orientation_rms_mrad']:.3g} mrad; "
        f"over the second half of each path, with the start forgotten, {ratio(slow, settled)} and "
        f"{ratio(fast, settled)} times in position. The {rows['I', 'exact'][settled]:.2g} and "
        f"{rows['II', 'exact'][settled]:.2g} mm that `exact` is left with there come from holding the forces."
    )


def with_friction(friction: dict[str, list[float]], rows: dict[tuple[str, str], Figures]) -> str:
    """What friction in the model gains."""
    C_u, C_p, C_s = (friction[name][0] for name in ("C_u", "C_p", "C_s"))
    turning = f"{C_u:g}" if C_u == C_s else f"{C_u:g} and {C_s:g}"
    errors = [
        f"{rows[path, name]['position_rms_mm']:.3g}" for path in ("I", "II") for name in ("gravity", "exact")
    ]
    return paragraph(
        f"The friction that the paper states is next to none. With {C_p:g} N s/m in the legs and {turning} "
        "N m s in the universal and spherical joints, PD with gravity compensation, whose model "
        f"has none, is {errors[0]} mm off on Path I and {errors[2]} mm on Path II, `exact` {errors[1]} and "
        f"{errors[3]} mm."
    )


def ratio(row: Figures, name: str) -> str:
    """The ratio to `exact` with three digits, and no exponent."""
    value = row[f"{name}_to_exact"]
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"
