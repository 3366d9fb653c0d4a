"""Table of the documentation from ``controller.json``: instructions and memory on two microcontrollers."""

from ...derive.emit.torque import torque_operations
from ..common.output import Figures, paragraph, table
from .report import name


def tables(found: Figures) -> dict[str, str]:
    """Name -> Markdown."""
    return {"controller": conditions(found) + figures(found["rows"]) + remarks(found["rows"])}


def conditions(found: Figures) -> str:
    """Compilers, flags and poses."""
    compiler, emulator = found["tools"].values()
    gcc = f"{compiler.split(' (')[0]} {compiler.rsplit(') ', 1)[-1].split()[0]}"
    qemu = emulator.removeprefix("QEMU emulator version ").split(" (")[0]
    own = {row["core"]: f"`{' '.join(row['flags'])}` ({row['core']})" for row in found["rows"]}
    return paragraph(
        f"`stewart-sym controller` writes one-pose kernels for {found['robot']}, cross-compiles them with "
        f"{gcc}, `{' '.join(found['flags'])}` and {' or '.join(own.values())}, and runs them "
        f"under QEMU {qemu}, which counts instructions. The most of {poses(found['rows'])} poses, one "
        "of them with a leg near its joint singularity, all within the bounds of 50-digit forces; flash, RAM "
        "and stack in bytes:"
    )


def poses(rows: list[Figures]) -> str:
    """How many a kit tried: "17", or "15 to 17"."""
    counts = sorted({row["poses"] for row in rows})
    return " to ".join(str(count) for count in (counts[0], counts[-1])[: len(counts)])


def figures(rows: list[Figures]) -> str:
    """A row for each kit."""
    header = (
        *("kit", "processor", "instructions", "near singularity", "flash, kernel", "robot"),
        *("RAM, model", "stack, pose", "preparation", "error over bound"),
    )
    return table(header, [cells(row) for row in rows])


def cells(row: Figures) -> tuple[str, ...]:
    """Cells of a kit."""
    return (
        name(row, "`"),
        row["core"],
        number(row["instructions"]),
        number(row["near_singular_joints"]),
        number(row["flash"]["kernel"]),
        number(row["flash"]["robot"]),
        number(row["ram"].get("model", 0)),
        number(max(row["stack"]["pose"], row["stack"]["frames"])),
        number(row["stack"].get("prepare")),
        f"{row['worst']:.3f}",
    )


def remarks(rows: list[Figures]) -> str:
    """What the columns mean, and what the objects need."""
    assert not any(
        row["foreign"] or row["double"] or row["failed"] or row["rejected_wrongly"] for row in rows
    )
    assert not any(row["ram"]["kit"] for row in rows)
    return paragraph(
        "Near singularity: all six legs within 1/1000 rad of the fixed axes of their universal joints, the "
        "longest path through the kernel. The model, prepared once, is the caller's; the kits have no data "
        "of their own. From libraries the objects need only the square root and copies of memory; those in "
        "`float` hold no double-precision instruction."
    )


def number(value: int | None) -> str:
    """A count, or nothing."""
    return "" if value is None else f"{value:,}"


def drive_tables(found: Figures) -> dict[str, str]:
    """The same of a machine with a drive, with what its torques take."""
    rows = found["rows"]
    said = paragraph(
        f"The same of the robot `{found['robot']}` with the drive of the page on drives: instructions of the "
        "forces with rotors, and of what is called after them, `axial_forces`, which legs with rotors need "
        f"alone, and `motor_torques`, {torque_operations(False).total} operations without Stribeck's "
        f"friction, which this drive has none of, {torque_operations().total} with it, as "
        "`stewart_torque.h` says; flash of torques is that of both functions, their stack the "
        "deeper one; in bytes:"
    )
    header = (
        *("kit", "processor", "forces", "near singularity", "axial", "torques"),
        *("flash, forces", "flash, torques", "stack, forces", "stack, torques"),
    )
    return {"controller_drive": said + table(header, [drive_cells(row) for row in rows])}


def drive_cells(row: Figures) -> tuple[str, ...]:
    """Cells of a kit of a machine with a drive."""
    kit, core, forces, near, flash, *_ = cells(row)
    drive = row["drive"]
    counts = (number(drive.get(name)) for name in ("axial_forces", "motor_torques"))
    stacks = (cells(row)[7], number(drive["stack"]))
    return (kit, core, forces, near, *counts, flash, number(drive["flash"]), *stacks)
