"""Formulations: printed or corrected equations, base joint, and rotors.

All formulations use one derivation. They differ only in the switches of `Formulation`.
"""

from dataclasses import dataclass, replace

UNIVERSAL = "universal"
SPHERICAL = "spherical"


@dataclass(frozen=True)
class Formulation:
    """Switches of the derivation.

    With a spherical base joint the spin of a leg is undetermined and there is no constraint moment, so
    ``no_spin`` and ``moment_along_leg`` have no effect.

    Attributes
    ----------
    name : str
        Name in the user interface, ``exact`` or ``paper``.
    base_joint : str
        Joint at the base point, ``universal`` or ``spherical``.
    no_spin : bool
        Fault 1 of the printed equations: s.W = 0 and s.A = 0 in (6), (8), (9), although the universal joint
        couples the spin to the motion of the leg.
    moment_along_leg : bool
        Fault 2: the constraint moment in (17), (19), (20) is M_u s instead of M_u n with n = k x y.
    transport_twice : bool
        Fault 3: (16) adds m_u L^2 diag(0, 1, 1), although (18) already contains this term.
    drive : bool
        The legs have rotors that turn in proportion to the leg length.
    """

    name: str
    base_joint: str
    no_spin: bool
    moment_along_leg: bool
    transport_twice: bool
    drive: bool = False

    @property
    def kernel_name(self) -> str:
        """Name of the emitted kernel, such as ``exact``, ``paper_spherical``, or ``exact_drive``."""
        joint = "" if self.base_joint == UNIVERSAL else f"_{self.base_joint}"
        return f"{self.name}{joint}{'_drive' if self.drive else ''}"


EXACT = Formulation("exact", UNIVERSAL, no_spin=False, moment_along_leg=False, transport_twice=False)
PAPER = Formulation("paper", UNIVERSAL, no_spin=True, moment_along_leg=True, transport_twice=True)
EXACT_SPHERICAL, PAPER_SPHERICAL = (replace(form, base_joint=SPHERICAL) for form in (EXACT, PAPER))
EXACT_DRIVE = replace(EXACT, drive=True)
EXACT_SPHERICAL_DRIVE = replace(EXACT_SPHERICAL, drive=True)
FORMULATIONS = (EXACT, PAPER, EXACT_SPHERICAL, PAPER_SPHERICAL, EXACT_DRIVE, EXACT_SPHERICAL_DRIVE)
BY_KERNEL = {form.kernel_name: form for form in FORMULATIONS}
"""Formulations by kernel name."""
