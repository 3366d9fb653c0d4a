"""The control study for people and programs: table, CSV rows, JSON, and curves over time."""

import functools
from collections.abc import Mapping, Sequence
from typing import Any

from ..common.drawing import BLUE, DARK, RED, Figure, as_written, legend_below, log_numbers, new_figure
from ..common.output import Columns, Figures, aligned, csv_text, of_legs, paragraph, table
from ..common.report import Picture, Report, Table
from .control import Run, Settings, Study

NAMES = {"exact": "`exact`", "paper": "`paper`", "massless": "massless legs", "gravity": "PD + gravity"}
_HEADER = (
    *("machine", "path", "controller"),
    *("pos RMS mm", "max mm", "RMS/exact", "ori RMS mrad", "max mrad", "RMS/exact"),
    *("peak N", "RMS N", "peak/exact"),
)
_COLUMNS = tuple(
    column
    for measured in (
        ("position_rms_mm", "position_max_mm"),
        ("orientation_rms_mrad", "orientation_max_mrad"),
        ("force_peak_N", "force_rms_N"),
    )
    for column in (*measured, f"{measured[0]}_to_exact")
)
_STYLE: Mapping[str, Mapping[str, Any]] = {
    "exact": {"color": BLUE, "linewidth": 3.4, "alpha": 0.45},
    "paper": {"color": RED, "linewidth": 1.3},
    "massless": {"color": DARK, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
    "gravity": {"color": "#2a8a4a", "linewidth": 1.3, "linestyle": (0, (1.2, 1.2))},
}

_UNITS = {
    "rate": "Hz",
    "k_p": "1/s^2",
    "k_d": "1/s",
    "offset_t": "m",
    "offset_phi": "rad",
    "step": "s",
    "C_u": "N m s",
    "C_p": "N s/m",
    "C_s": "N m s",
}


def full_report(studies: Mapping[str, Study]) -> Report:
    """Table, figures, errors and forces over time, and a picture of each machine."""
    tables: dict[str, Table] = {"control": csv_rows(studies)}
    figures = {}
    for number, (label, study) in enumerate(studies.items()):
        suffix = f"_{label}" if number else ""
        tables |= {f"path_{path}{suffix}": run_columns(runs) for path, runs in study.runs.items()}
        figures[f"control{suffix}"] = Picture(functools.partial(figure, study))
    return Report(report(studies), tables, as_json(studies), figures)


def report(studies: Mapping[str, Study]) -> str:
    """What was run, in two lines, and the table."""
    rows = [
        [label, row["path"], NAMES[row["controller"]], *(f"{row[column]:.4g}" for column in _COLUMNS)]
        for label, study in studies.items()
        for row in study.rows()
    ]
    settings = next(iter(studies.values())).settings
    return f"{conditions(settings)}\n\n{aligned(_HEADER, rows, left=3)}"


def conditions(settings: Settings) -> str:
    """Rate, gains and start in words."""
    t, phi = vector(settings.offset_t), vector(settings.offset_phi)
    return (
        f"Plant `exact`; forces held at {settings.rate:g} Hz, k_p = {settings.k_p:g} 1/s^2, k_d = "
        f"{settings.k_d:g} 1/s.\nStart off the path by {t} mm, turned by {phi} mrad."
    )


def vector(values: Sequence[float]) -> str:
    """Thousandths of the numbers given, in brackets: mm of m, mrad of rad."""
    return f"({', '.join(f'{1e3 * value:g}' for value in values)})"


def csv_rows(studies: Mapping[str, Study]) -> str:
    """The table as CSV, every figure with all its digits."""
    rows = [{"machine": label, **row} for label, study in studies.items() for row in study.rows()]
    return csv_text([list(rows[0]), *(list(row.values()) for row in rows)])


def as_json(studies: Mapping[str, Study]) -> dict[str, Any]:
    """Settings and, by label, machines with their figures."""
    settings = next(iter(studies.values())).settings
    machines = {label: study.as_json() for label, study in studies.items()}
    return {"settings": {**vars(settings)}, "machines": machines, "units": _UNITS}


def run_columns(runs: Mapping[str, Run]) -> Columns:
    """Columns (n,) of one path: time, s, and for each controller errors, m and rad, and forces, N."""
    columns: Columns = {"time": next(iter(runs.values())).time}
    for name, run in runs.items():
        columns |= {f"{name}_position": run.position, f"{name}_orientation": run.orientation}
        columns |= of_legs(f"{name}_F", run.F)
    return columns


def figure(study: Study) -> Figure:
    """Errors, on logarithmic axes, and the force of the hardest working leg over time, a column a path."""
    picture = new_figure(10.0, 8.0)
    grid = picture.subplots(3, len(study.runs), sharex="col", sharey="row", squeeze=False)
    for column, (path, runs) in zip(grid.T, study.runs.items(), strict=True):
        column[0].set_title(f"Path {path}", fontsize=10.0)
        for name, run in runs.items():
            style = {**_STYLE[name], "label": NAMES[name].replace("`", "")}
            column[0].semilogy(run.time, 1e3 * run.position, **style)
            column[1].semilogy(run.time, 1e3 * run.orientation, **style)
            column[2].plot(run.time, run.largest_force, **style)
        column[2].set_xlabel("time, s")
        for axes in column:
            axes.margins(x=0.0)
        for axes in column[:2]:
            log_numbers(axes.yaxis)
    labels = ("position error, mm", "orientation error, mrad", "largest force, N")
    for row, label in zip(grid, labels, strict=True):
        row[0].set_ylabel(label)
    picture.suptitle(as_written(study.robot.name), fontsize=10.0)
    legend_below(picture)
    return picture


def tables(found: Figures) -> dict[str, str]:
    """Table of the documentation from ``control.json``: tracking errors by the model in the controller."""
    printed, friction = (by_name(found["machines"][label]["rows"]) for label in ("printed", "friction"))
    parts = [
        _published_conditions(found["settings"]),
        _figures(found["machines"]["printed"]["rows"]),
        _legs(printed),
        _faults(printed),
        _with_friction(found["machines"]["friction"]["friction"], friction),
    ]
    return {"control": "".join(parts)}


def by_name(rows: list[Figures]) -> dict[tuple[str, str], Figures]:
    """Rows by path and controller."""
    return {(row["path"], row["controller"]): row for row in rows}


def _published_conditions(given: dict[str, Any]) -> str:
    settings = Settings(**given)
    t, phi = (vector(offset) for offset in (settings.offset_t, settings.offset_phi))
    return paragraph(
        "`stewart-sym control` tracks the paper's Paths I and II with controllers that differ only in "
        "their model of the machine. Three use computed torque with `exact`, `paper`, or massless legs, "
        "(41); the fourth is PD control with gravity compensation of the whole machine. The plant is "
        f"`exact`. Forces are constant between samples at {settings.rate:g} Hz; k_p = {settings.k_p:g} "
        f"1/s^2, k_d = {settings.k_d:g} 1/s. The start differs from the path by {t} mm and {phi} mrad. "
        "Ratios of RMS errors and peak forces are to `exact`."
    )


def _figures(rows: list[Figures]) -> str:
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
                    _ratio(row, f"{kind}_rms_{unit}"),
                )
            ),
            f"{row['force_peak_N']:.0f}",
            f"{row['force_rms_N']:.0f}",
            f"{row['force_peak_N_to_exact']:.3f}",
        )
        for row in rows
    ]
    return table(header, cells)


def _legs(rows: dict[tuple[str, str], Figures]) -> str:
    slow, fast = rows["I", "massless"], rows["II", "massless"]
    slow_pd, fast_pd = rows["I", "gravity"], rows["II", "gravity"]
    return paragraph(
        "Effect of the legs: with massless legs in the model the errors are "
        f"{slow['position_rms_mm']:.3g} mm and {slow['orientation_rms_mrad']:.3g} mrad on Path I, "
        f"{fast['position_rms_mm']:.3g} mm and {fast['orientation_rms_mrad']:.3g} mrad on Path II. This is "
        f"{_ratio(slow, 'position_rms_mm')} and {_ratio(fast, 'position_rms_mm')} times the position error "
        f"of `exact`, with {slow['force_peak_N_to_exact']:.2f} and {fast['force_peak_N_to_exact']:.2f} times "
        "its peak force. On Path I the weight of the legs causes the error: PD control with the whole "
        f"machine's weight and no inertia has {slow_pd['position_rms_mm']:.3g} mm there. On Path II, the "
        f"same line in a tenth of the time, its error is {fast_pd['position_rms_mm']:.3g} mm, "
        f"{_ratio(fast_pd, 'position_rms_mm')} times the error of `exact`."
    )


def _faults(rows: dict[tuple[str, str], Figures]) -> str:
    slow, fast = rows["I", "paper"], rows["II", "paper"]
    settled = "position_settled_rms_mm"
    return paragraph(
        "Effect of the faults of the printed equations: the position error of `paper` is "
        f"{_ratio(slow, 'position_rms_mm')} and {_ratio(fast, 'position_rms_mm')} times the error of "
        f"`exact`. Its orientation errors are {slow['orientation_rms_mrad']:.3g} and "
        f"{fast['orientation_rms_mrad']:.3g} mrad, {_ratio(slow, 'orientation_rms_mrad')} and "
        f"{_ratio(fast, 'orientation_rms_mrad')} times the errors of `exact`. Over the second half of each "
        f"path, after the start has decayed, the position error is {_ratio(slow, settled)} and "
        f"{_ratio(fast, settled)} times as large. The remaining errors of `exact`, "
        f"{rows['I', 'exact'][settled]:.2g} and {rows['II', 'exact'][settled]:.2g} mm, result from the "
        "constant forces between samples."
    )


def _with_friction(friction: dict[str, list[float]], rows: dict[tuple[str, str], Figures]) -> str:
    C_u, C_p, C_s = (friction[name][0] for name in ("C_u", "C_p", "C_s"))
    turning = f"{C_u:g}" if C_u == C_s else f"{C_u:g} and {C_s:g}"
    errors = [
        f"{rows[path, name]['position_rms_mm']:.3g}" for path in ("I", "II") for name in ("gravity", "exact")
    ]
    return paragraph(
        f"The friction in the paper is almost zero. With {C_p:g} N s/m in the legs and {turning} N m s in "
        "the universal and spherical joints, the errors of PD control with gravity compensation are "
        f"{errors[0]} mm on Path I and {errors[2]} mm on Path II, as its model has no friction. The "
        f"errors of `exact` are {errors[1]} and {errors[3]} mm."
    )


def _ratio(row: Figures, name: str) -> str:
    """The ratio to `exact` with three digits, and no exponent."""
    value = row[f"{name}_to_exact"]
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"
