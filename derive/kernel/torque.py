"""Motor torques, and the axial forces that determine the friction of a screw, as trees."""

from math import factorial

from ..mechanics import quantities as n
from ..program.block import Block
from ..trace import nodes as t
from ..trace.read import Entries, Given
from .elimination import RETURNED
from .interface import STRUCTS
from .layouts import Arguments, Written, block_function, structure
from .prepare import machine_structures, result
from .written import legs

DRIVES = t.Structure(
    "Drives",
    "Constants of six drives.",
    tuple(t.numbers(m.name, *m.stored, meaning=f"{m.unit}: {m.meaning}") for m in STRUCTS["drives"]),
)
_TORQUES = result(
    "Torques",
    "Torques and currents of six motors.",
    t.numbers("torque", 6, meaning="N m: torques"),
    t.numbers("current", 6, meaning="A: currents"),
)
_AXIAL = result(
    "AxialLoads",
    "Axial forces of six legs.",
    t.numbers("axial", 6, meaning="N: forces between the parts of the legs"),
    t.numbers("L_dot", 6, meaning="m/s: rates of the lengths, (5)"),
)


def torque_program() -> t.Program:
    """``motor_torques``: torques and currents from forces and rates."""
    last, *factors = (t.Number(1.0 / factorial(k)) for k in range(12, 1, -1))
    series: dict[str, Given] = {"LAST": last, "FACTORS": Entries(tuple(factors))}
    made = Written.of((DRIVES, _TORQUES), given=series)
    made.add(legs.decay_of, legs.sign_of, legs.motor_torques)
    return made.program("torque")


def axial_program(block: Block) -> t.Program:
    """``axial_forces`` of legs with rotors; block: a leg's, as ``mechanics.axial_forces`` makes it."""
    of_leg: Arguments = {"leg": ("Leg", n.OF_LEG), "motion": ("Motion", n.MOTION)}
    held = (*machine_structures(drive=True), structure("RotorTerms", "A leg.", block.made), _AXIAL)
    made = Written.of(held, [block_function(block, "axial_terms", "RotorTerms", of_leg)], RETURNED)
    made.add(legs.largest_component, legs.reach_of, legs.fault_of, legs.axial_forces)
    return made.program("axial")
