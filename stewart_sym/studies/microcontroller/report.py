"""The study of a controller's processor for people and programs: a table and JSON."""

from collections.abc import Sequence

from ..common.output import Figures, aligned
from ..common.report import Report

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


def full_report(found: Figures) -> Report:
    """The table, and all figures with the tools that made them."""
    return Report(report(found), data={**found, "units": _UNITS})


def report(found: Figures) -> str:
    """What was run, in some lines, and the table."""
    rows = found["rows"]
    lines = [
        f"{found['robot']}, fidelity {found['fidelity']}: one-pose kernels, {' '.join(found['flags'])}",
        *(f"{row['core']}: {' '.join(row['flags'])}, QEMU {row['board']}" for row in rows if row["baked"]),
        *found["tools"].values(),
        "Instructions are executed ones of a call, the most of the poses tried; near joints: with all legs",
        "near the singularities of their universal joints. Flash, RAM and stack in bytes; stack of a pose as",
        "painted and found again, and of all frames on its deepest way, as the compiler says; of the",
        "preparation as painted.",
    ]
    tables = [aligned(HEADER, [cells(row) for row in rows], left=3)]
    if any(row["drive"] for row in rows):
        names = ("axial_forces", "motor_torques", "flash", "stack")
        drives = [[name(row), row["core"], *_counts(row["drive"], names)] for row in rows]
        tables.append(aligned(DRIVE_HEADER, drives, left=2))
    return "\n\n".join(["\n".join(lines), *tables])


def name(row: Figures, quote: str = "") -> str:
    """A kit in words."""
    return f"{'baked' if row['baked'] else 'general'}, {quote}{row['precision']}{quote}"


def cells(row: Figures) -> list[str]:
    """One line of the table."""
    return [
        name(row),
        row["core"],
        _answers(row),
        f"{row['worst']:.3f}",
        *_counts(row, ("instructions", "near_singular_joints")),
        *_counts(row["flash"], ("kernel", "robot", "image")),
        *_counts(row["ram"], ("kit", "model")),
        *_counts(row["stack"], ("pose", "frames", "prepare")),
        ", ".join(row["foreign"]) or "none",
        (", ".join(row["double"]) or "none") if row["precision"] == "float" else "-",
    ]


def _counts(found: Figures, names: Sequence[str]) -> list[str]:
    return ["-" if found.get(name) is None else f"{found[name]:,}" for name in names]


def _answers(row: Figures) -> str:
    """Whether forces, statuses and the kit's own test came out right."""
    counts = {"forces": "failed", "statuses": "rejected_wrongly", "self-test": "selftest"}
    said = [f"{what} wrong" for what, count in counts.items() if row[count]]
    return "; ".join(said) or f"{row['poses']} poses right"
