"""C99 files of the motor torques, and of the axial forces of legs with rotors, for one pose."""

from random import Random

from ..kernel.interface import STRUCTS
from ..kernel.torque import axial_program, torque_program
from ..mechanics.formulation import SPHERICAL, Formulation
from ..program.block import Block, Operations
from ..trace.decided_selections import of_one_pose
from ..trace.operation_counter import counted
from .header import member_text
from .kinematics import OF_STEWART_H, files


def torque_operations(stribeck: bool = True) -> Operations:
    """Count the operations of six legs with or without Stribeck friction."""
    draw = Random(1)
    return counted(
        torque_program(),
        "motor_torques",
        lambda name: 0.0 if name == "stribeck" and not stribeck else draw.uniform(0.5, 1.5),
    )


def torque_files(version: str) -> dict[str, str]:
    """Return ``stewart_torque``: torques and currents from forces and length rates."""
    return files(
        "torque",
        of_one_pose(torque_program()),
        {"Drives": "stewart_drives"},
        version,
        operations=torque_operations(),
        without=torque_operations(stribeck=False),
        drives="\n".join(map(member_text, STRUCTS["drives"])),
    )


def axial_name(form: Formulation, reflected: bool = False) -> str:
    """Return the name of header and source of a formulation with rotors, or with reflected masses only."""
    return f"stewart_{form.kernel_name}{'_reflected' if reflected else ''}_axial"


def axial_operations(block: Block) -> Operations:
    """Count the operations of six legs."""
    return 6 * (block.operations() + Operations(add=1))


def axial_files(form: Formulation, block: Block, version: str, reflected: bool = False) -> dict[str, str]:
    """Return ``stewart_..._axial`` of a formulation with rotors from the block of a leg.

    ``reflected`` is as in ``axial_name``.
    """
    file, masses = axial_name(form, reflected), reflected or form.base_joint == SPHERICAL
    return files(
        "axial",
        of_one_pose(axial_program(block)),
        OF_STEWART_H,
        version,
        rotors=True,
        file=file,
        symbol=f"{file}_forces",
        read="b, p, and m_r" if masses else "b, p, k, m_r, and j_r",
        turns="m_r L_ddot" if masses else "m_r L_ddot + j_r A.s with the angular acceleration A of the leg",
        operations=axial_operations(block),
        statuses=f"STEWART_NOT_FINITE, STEWART_ZERO_LENGTH{'' if masses else ', STEWART_JOINT_SINGULAR'}",
    )
