"""The formulations: with the four errors of the printed equations or without, and the legs' base joint.

One derivation serves all of them; the switches here are the only places where they differ.
"""

from dataclasses import dataclass, replace

UNIVERSAL = "universal"
SPHERICAL = "spherical"


@dataclass(frozen=True)
class Formulation:
    """Switches of the derivation.

    name: as the user says it; base_joint: ``universal`` or ``spherical``.
    no_spin: fault 1, s.W = 0 and s.A = 0 in (6), (8), (9) although the universal joint spins the leg.
    moment_along_leg: fault 2, the constraint moment is M_u s in (17), (19), (20) instead of M_u n.
    drive: the legs have rotors that turn with their lengths.
    transport_twice: fault 3, (16) adds m_u L^2 diag(0, 1, 1) although (18) carries the transport already.

    With a spherical base joint nothing fixes the spin and there is no constraint moment: the first two
    switches have no effect.
    """

    name: str
    base_joint: str
    no_spin: bool
    moment_along_leg: bool
    transport_twice: bool
    drive: bool = False

    @property
    def kernel_name(self) -> str:
        """Name of the emitted kernel: ``exact``, ``paper_spherical``, ``exact_drive``."""
        joint = "" if self.base_joint == UNIVERSAL else f"_{self.base_joint}"
        return f"{self.name}{joint}{'_drive' if self.drive else ''}"


EXACT = Formulation("exact", UNIVERSAL, no_spin=False, moment_along_leg=False, transport_twice=False)
PAPER = Formulation("paper", UNIVERSAL, no_spin=True, moment_along_leg=True, transport_twice=True)
EXACT_SPHERICAL, PAPER_SPHERICAL = (replace(form, base_joint=SPHERICAL) for form in (EXACT, PAPER))
EXACT_DRIVE = replace(EXACT, drive=True)
EXACT_SPHERICAL_DRIVE = replace(EXACT_SPHERICAL, drive=True)
FORMULATIONS = (EXACT, PAPER, EXACT_SPHERICAL, PAPER_SPHERICAL, EXACT_DRIVE, EXACT_SPHERICAL_DRIVE)
BY_KERNEL = {form.kernel_name: form for form in FORMULATIONS}
"""Formulations by the names of their kernels."""
