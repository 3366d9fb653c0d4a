"""Tables of the documentation from the figures of ``microcontroller``."""

from markdown_text import paragraph, table

from stewart_sym.derive.emit.torque import torque_operations
from stewart_sym.studies.common.text_tables import Figures


def tables(found: Figures) -> dict[str, str]:
    """Return the table of instructions and memory on both processors from ``controller.json``."""
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
        f"`tests/support/studies/microcontroller.py` writes one-pose kernels for {found['robot']}, cross-"
        f"compiles them with {gcc}, `{' '.join(found['flags'])}` and {' or '.join(own.values())}, and runs "
        f"them under QEMU {qemu}, which counts instructions. The table lists the largest number over {poses} "
        "poses, one of them with a leg near its joint singularity. All forces are within the error bounds "
        "around 50-digit forces. Flash, RAM, and stack are in bytes."
    )


def _published(row: Figures) -> tuple[str, ...]:
    return (
        f"{'baked' if row['baked'] else 'not baked'}, `{row['precision']}`",
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


def kinematics_tables(found: Figures) -> dict[str, str]:
    """Return the table of inverse and forward kinematics from ``controller_kinematics.json``."""
    rows = found["rows"]
    assert not any(row["failed"] for row in rows)
    said = paragraph(
        "The next table lists the instructions of the kinematics for the same robot, the largest number over "
        f"{rows[0]['poses']} poses. `stewart_forward_kinematics` starts from a guess that differs from the "
        "pose by 1/1000 rad and 1/1000 of the size of the platform, as from the previous cycle of a "
        "controller. Flash is in bytes."
    )
    header = ("kit", "processor", "lengths", "lengths and rates", "forward kinematics", "flash")
    cells = []
    for row in rows:
        counts = [_number(row[name][1]) for name in ("lengths", "rates", "search")]
        cells.append((f"`{row['precision']}`", row["core"], *counts, _number(row["flash"])))
    return {"controller_kinematics": said + table(header, cells)}


def _number(value: int | None) -> str:
    return "" if value is None else f"{value:,}"


def drive_tables(found: Figures) -> dict[str, str]:
    """Return the table of a machine with a drive, including its torques, from ``controller_drive.json``."""
    rows = found["rows"]
    said = paragraph(
        f"The next table is for the robot `{found['robot']}` with the drive of the page on drives. It lists "
        "the instructions of the forces with rotors, of `axial_forces`, which only legs with rotors require, "
        f"and of `motor_torques`. The torques require {torque_operations(False).total} operations without "
        f"Stribeck friction, as here, and {torque_operations().total} with it (`stewart_torque.h`). For the "
        "torques, flash is the sum of both functions, and stack the larger of the two, in bytes."
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
