"""The study of a controller's processor for people and programs: a table and JSON."""

from collections.abc import Sequence

from ...derive.emit.torque import torque_operations
from ..common.output import Figures, aligned, paragraph, table
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


def tables(found: Figures) -> dict[str, str]:
    """Table of the documentation from ``controller.json``: instructions and memory on both processors."""
    rows = found["rows"]
    assert not any(
        row["foreign"] or row["double"] or row["failed"] or row["rejected_wrongly"] for row in rows
    )
    assert not any(row["ram"]["kit"] for row in rows)
    header = (
        *("kit", "processor", "instructions", "near singularity", "flash, kernel", "robot"),
        *("RAM, model", "stack, pose", "preparation", "error over bound"),
    )
    remarks = paragraph(
        "Near singularity: all six legs within 1/1000 rad of the fixed axes of their universal joints, the "
        "longest path through the kernel. The caller owns the model, which is prepared once; the kits have "
        "no static data. The object files need only the square root and memory copies from libraries. The "
        "`float` object files contain no double-precision instruction."
    )
    return {"controller": _conditions(found) + table(header, [_published(row) for row in rows]) + remarks}


def _conditions(found: Figures) -> str:
    compiler, emulator = found["tools"].values()
    gcc = f"{compiler.split(' (')[0]} {compiler.rsplit(') ', 1)[-1].split()[0]}"
    qemu = emulator.removeprefix("QEMU emulator version ").split(" (")[0]
    least, most = (extreme(row["poses"] for row in found["rows"]) for extreme in (min, max))
    poses = str(most) if least == most else f"{least} to {most}"
    own = {row["core"]: f"`{' '.join(row['flags'])}` ({row['core']})" for row in found["rows"]}
    return paragraph(
        f"`stewart-sym controller` writes one-pose kernels for {found['robot']}, cross-compiles them with "
        f"{gcc}, `{' '.join(found['flags'])}` and {' or '.join(own.values())}, and runs them "
        f"under QEMU {qemu}, which counts instructions. The table lists the largest number over {poses} "
        "poses, one of them with a leg near its joint singularity. All forces are within the error bounds "
        "around 50-digit forces. Flash, RAM, and stack are in bytes."
    )


def _published(row: Figures) -> tuple[str, ...]:
    return (
        name(row, "`"),
        row["core"],
        _number(row["instructions"]),
        _number(row["near_singular_joints"]),
        _number(row["flash"]["kernel"]),
        _number(row["flash"]["robot"]),
        _number(row["ram"].get("model", 0)),
        _number(max(row["stack"]["pose"], row["stack"]["frames"])),
        _number(row["stack"].get("prepare")),
        f"{row['worst']:.3f}",
    )


def _number(value: int | None) -> str:
    return "" if value is None else f"{value:,}"


def drive_tables(found: Figures) -> dict[str, str]:
    """The same of a machine with a drive, with what its torques take."""
    rows = found["rows"]
    said = paragraph(
        f"The next table is for the robot `{found['robot']}` with the drive of the page on drives. It lists "
        "the instructions of the forces with rotors, of `axial_forces`, which only legs with rotors need, "
        f"and of `motor_torques`. The torques take {torque_operations(False).total} operations without "
        f"Stribeck friction, as here, and {torque_operations().total} with it (`stewart_torque.h`). Flash of "
        "the torques is the sum of both functions, and stack is the deeper one, in bytes."
    )
    header = (
        *("kit", "processor", "forces", "near singularity", "axial", "torques"),
        *("flash, forces", "flash, torques", "stack, forces", "stack, torques"),
    )
    return {"controller_drive": said + table(header, [_published_drive(row) for row in rows])}


def _published_drive(row: Figures) -> tuple[str, ...]:
    kit, core, forces, near, flash, _, _, stack, *_ = _published(row)
    drive = row["drive"]
    counts = (_number(drive.get(name)) for name in ("axial_forces", "motor_torques"))
    return (kit, core, forces, near, *counts, flash, _number(drive["flash"]), stack, _number(drive["stack"]))
