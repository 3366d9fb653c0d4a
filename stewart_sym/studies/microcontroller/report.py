"""The study of a controller's processor for people and programs: a table and JSON."""

from ..common.output import aligned
from ..common.report import Report
from .measure import Figures, Study

HEADER = (
    *("kit", "core", "answers", "worst/bound", "instructions", "near joints"),
    *("flash kernel", "robot", "image"),
    *("RAM kit", "model", "stack pose", "frames", "prepare", "foreign symbols", "doubles"),
)

DRIVE_HEADER = ("kit", "core", "axial forces", "motor torques", "flash", "stack")

_UNITS = {
    "drive": "instructions per call, and bytes",
    "worst": "share of the bound",
    "instructions": "per call",
    "near_singular_joints": "instructions per call",
    **dict.fromkeys(("flash", "ram", "stack"), "bytes"),
}


def full_report(study: Study) -> Report:
    """The table, and all figures with the tools that made them."""
    return Report(report(study), data={**study.as_json(), "units": _UNITS})


def report(study: Study) -> str:
    """What was run, in some lines, and the table."""
    lines = [
        f"{study.robot}, fidelity {study.fidelity}: one-pose kernels, {' '.join(study.flags)}",
        *(f"{row.core}: {' '.join(row.flags)}, QEMU {row.board}" for row in study.rows if row.baked),
        *study.tools.values(),
        "Instructions are executed ones of a call, the most of the poses tried; near joints: with all legs",
        "near the singularities of their universal joints. Flash, RAM and stack in bytes; stack of a pose as",
        "painted and found again, and of all frames on its deepest way, as the compiler says; of the",
        "preparation as painted.",
    ]
    tables = [aligned(HEADER, [cells(row) for row in study.rows], left=3)]
    if any(row.drive for row in study.rows):
        tables.append(aligned(DRIVE_HEADER, [drive_cells(row) for row in study.rows], left=2))
    return "\n\n".join(["\n".join(lines), *tables])


def drive_cells(row: Figures) -> list[str]:
    """One line of the table of torques."""
    names = ("axial_forces", "motor_torques", "flash", "stack")
    return [row.name, row.core, *(f"{row.drive[name]:,}" if name in row.drive else "-" for name in names)]


def cells(row: Figures) -> list[str]:
    """One line of the table."""
    return [
        row.name,
        row.core,
        answers(row),
        f"{row.worst:.3f}",
        f"{row.instructions:,}",
        "-" if row.near_singular_joints is None else f"{row.near_singular_joints:,}",
        *(f"{row.flash[name]:,}" for name in ("kernel", "robot", "image")),
        *(f"{row.ram[name]:,}" if name in row.ram else "-" for name in ("kit", "model")),
        *(f"{row.stack[name]:,}" if name in row.stack else "-" for name in ("pose", "frames", "prepare")),
        ", ".join(row.foreign) or "none",
        (", ".join(row.double) or "none") if row.precision == "float" else "-",
    ]


def answers(row: Figures) -> str:
    """Whether forces, statuses and the kit's own test came out right."""
    wrong = {"forces": row.failed, "statuses": row.rejected_wrongly, "self-test": row.selftest}
    said = [f"{name} wrong" for name, count in wrong.items() if count]
    return "; ".join(said) or f"{row.poses} poses right"
