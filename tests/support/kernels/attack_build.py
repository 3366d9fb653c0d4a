"""Builds the attack of tests/support/c on every C file of generated/c with any compiler and flags."""

import shutil
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from importlib.resources import files
from os import cpu_count
from pathlib import Path

from builds import written
from sweeps import FULL

from stewart_sym.backend.kernel import digests, generated_text
from stewart_sym.generated.interface import HEADERS

ATTACK = Path(__file__).parents[1] / "c"
# To note which line code comes from takes a quarter of the time; functions are named without.
STRICT = ("-std=c99", "-ffp-contract=off", "-fno-math-errno", "-g" if FULL else "-g0")


def rotor_flags(kernel: str) -> list[str]:
    """The compiler flags that the C code of a kernel requires."""
    return ["-DSTEWART_ROTORS"] if "_drive" in kernel else []


def stems() -> list[str]:
    """Sources of the generated C without suffix, committed or derived at first use."""
    names = [*digests(), *(path.name for path in (files("stewart_sym.generated") / "c").iterdir())]
    return sorted(Path(name).stem for name in names if name.endswith(".c"))


def sources(*stems: str) -> dict[str, str]:
    """Text of sources, their headers, and the shared headers, by file name."""
    names = [*HEADERS, *(f"{stem}{suffix}" for stem in stems for suffix in (".h", ".c"))]
    # The header of a closed form includes the header of its prepared constants.
    names += [stem.replace("_motion", "_forces.h") for stem in stems if stem.endswith("_motion")]
    return {name: generated_text(f"c/{name}") for name in names}


def oracles(rotors: bool = False) -> dict[str, tuple[str, str]]:
    """Source of generated/c, without suffix -> prefix of its functions and name of its oracle.

    rotors: of the sources for legs with rotors, whose robots have another layout; else of the others.
    """
    found = {}
    for name in stems():
        kernel = name.removeprefix("stewart_")
        # Of rotations no pointer leads beyond three vectors; they are held to ``Motion`` with the kits.
        if ("_drive" in kernel) == rotors and kernel != "rotation":
            stem, _, kind = kernel.rpartition("_")
            if kind in ("motion", "regressor", "bounds", "axial", "forces"):
                found[name] = (stem, kind)
            else:
                found[name] = (kernel, kernel if kernel in ALONE else "dynamics")
    return found


ALONE = ("kinematics", "legs", "torque")
"""Sources with an oracle of their own."""
SOME = (
    *("stewart_exact", "stewart_exact_motion", "stewart_exact_bounds", "stewart_kinematics"),
    *("stewart_legs", "stewart_exact_regressor", "stewart_torque"),
    *("stewart_exact_forces", "stewart_exact_massless_static_forces", "stewart_paper_spherical_forces"),
)
"""One source of each printer and each way that it goes."""
FEW = (
    *("stewart_exact", "stewart_exact_massless_static_forces", "stewart_kinematics", "stewart_legs"),
    "stewart_torque",
)
"""The shortest of these."""
SOME_WITH_ROTORS = (
    *("stewart_exact_drive", "stewart_exact_drive_forces", "stewart_exact_drive_reflected_massless_forces"),
    *("stewart_exact_spherical_drive_forces", "stewart_exact_drive_axial"),
)
"""Of legs with rotors those whose text differs most from that without."""


def built(
    folder: Path,
    compiler: str,
    flags: Sequence[str],
    main: str | None = "attack_driver.c",
    link: Sequence[str] = (),
    chosen: Sequence[str] | None = None,
    rotors: bool = False,
) -> Path:
    """The attack as a program in ``folder``; main: the file that holds it, None where a flag brings one.

    flags: of every compilation; link: of the last alone. chosen: the sources to attack, None for all. rotors:
    of those for legs with rotors. Raises CalledProcessError with what was printed.
    """
    every = oracles(rotors)
    attacked = every if chosen is None else {stem: every[stem] for stem in chosen}
    flags = [*flags, *(["-DSTEWART_ROTORS"] if rotors else [])]
    names = [f"ORACLE(attack_{kernel}_{oracle})" for kernel, oracle in attacked.values()]
    (folder / "attack_kernels.h").write_text("\n".join(names) + "\n")
    generated = written(sources(*attacked), folder / "generated")
    common = [compiler, *STRICT, *flags, f"-I{folder}", f"-I{generated}", f"-I{ATTACK}", "-c"]
    jobs = [[str(ATTACK / "attack.c"), "-o", "case.o"]]
    if main is not None:
        jobs.append([str(ATTACK / main), f"-DKERNELS={len(attacked)}", "-o", "main.o"])
    for stem, (kernel, oracle) in attacked.items():
        jobs.append([str(generated / f"{stem}.c"), "-o", f"{stem}.o"])
        named = [f"-DKERNEL={kernel}", f'-DHEADER="{stem}.h"']
        jobs.append([str(ATTACK / f"attack_{oracle}.c"), *named, "-O0", "-o", f"oracle_{stem}.o"])
    with ThreadPoolExecutor(cpu_count() or 1) as pool:
        list(pool.map(lambda job: ran([*common, *job], folder), jobs))
    program = folder / "attack"
    objects = [job[-1] for job in jobs]
    ran([compiler, *flags, *link, *objects, "-o", str(program), "-lm"], folder)
    return program


def ran(command: Sequence[str], folder: Path, timeout: float = 900.0) -> str:
    """What a command printed; AssertionError with its last lines if it fails."""
    done = subprocess.run(
        command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=timeout
    )
    text = done.stdout.decode("utf-8", "replace")
    assert done.returncode == 0, f"{' '.join(command)[:300]}\n{text[-3000:]}"
    return text


def works(folder: Path, compiler: str, flags: Sequence[str]) -> str | None:
    """Why a compiler can't make a program with these flags that runs, None if it can."""
    if shutil.which(compiler) is None:
        return f"{compiler} is not installed"
    fuzzer = any("fuzzer" in flag for flag in flags)
    function = "int LLVMFuzzerTestOneInput(const unsigned char *d, unsigned long n) { return d && n > 9; }\n"
    (folder / "probe.c").write_text(function if fuzzer else "int main(void) { return 0; }\n")
    try:
        ran([compiler, *flags, "probe.c", "-o", "probe"], folder)
        ran(["./probe", *(["-runs=1"] if fuzzer else [])], folder)
    except AssertionError as error:
        return f"{compiler} can't {' '.join(flags)}: {str(error).splitlines()[-1][:200]}"
    return None
