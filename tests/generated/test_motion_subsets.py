"""Some of the closed form's functions: the emitted C holds these and what they need, and nothing else."""

import functools
import re
import shutil
from pathlib import Path

import attack_build
import pytest

from stewart_sym.derive.emit import closed_form as emitted
from stewart_sym.derive.generate import EXACT, generator_version, motion_files, prepared_model, reduced_motion

KIT = [("equations", "bias", "forward_dynamics", "joint_inertia"), ("derivatives", "linearisation")]
SUBSETS = [*KIT, emitted.FUNCTIONS]
WARNINGS = ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wunused", "-Wmissing-prototypes", "-Werror"]


@pytest.fixture(scope="module")
def kernels():
    return reduced_motion(), prepared_model(EXACT)


@pytest.fixture(scope="module")
def written(kernels, tmp_path_factory: pytest.TempPathFactory):
    """Writes header and source of a subset, once, and returns their folder."""

    @functools.cache
    def write(functions: tuple[str, ...]) -> Path:
        folder = tmp_path_factory.mktemp("subset")
        for name, text in emitted.files(*kernels, generator_version(), functions).items():
            (folder / name).write_text(text)
        return folder

    return write


@pytest.mark.slow
@pytest.mark.parametrize("functions", SUBSETS, ids="+".join)
def test_a_subset_compiles_and_nothing_in_it_is_unused(written, functions: tuple[str, ...]) -> None:
    if shutil.which("gcc") is None:
        pytest.skip("gcc is not installed")
    command = ["gcc", *WARNINGS, "-fsyntax-only", f"-I{attack_build.GENERATED}", "stewart_exact_motion.c"]
    attack_build.ran(command, written(functions))


@pytest.mark.parametrize("functions", SUBSETS, ids="+".join)
def test_a_subset_has_the_functions_asked_for_and_their_batches(written, functions: tuple[str, ...]) -> None:
    folder = written(functions)
    names = {f"stewart_exact_{name}{batch}" for name in functions for batch in ("", "_batch")}
    header, source = ((folder / f"stewart_exact_motion{end}").read_text() for end in (".h", ".c"))
    assert set(re.findall(r"^STEWART_NODISCARD int (\w+)\(", header, re.M)) == names
    assert set(re.findall(r"^int (\w+)\(", source, re.M)) == names


def test_every_function_of_a_subset_is_that_of_the_whole(written) -> None:
    whole = (written(emitted.FUNCTIONS) / "stewart_exact_motion.c").read_text()
    for functions in KIT:
        part = (written(functions) / "stewart_exact_motion.c").read_text()
        bodies = re.findall(r"^(?:static )?((?:\w+ )+\w+\(.*?^}$)", part, re.M | re.S)
        assert len(bodies) > 10
        assert all(body in whole for body in bodies)


@pytest.mark.parametrize("functions", KIT, ids="+".join)
def test_a_subset_derived_alone_is_written_as_with_all_kernels(written, functions: tuple[str, ...]) -> None:
    folder = written(functions)
    for name, text in motion_files(functions).items():
        assert text == (folder / name).read_text()
