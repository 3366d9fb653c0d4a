"""No file of the repository has a former public name."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FOLDERS = ("derive", "generated", "stewart_sym", "tests", ".ci", ".docs")
BINARY = (".png", ".pyc", ".npy", ".npz", ".so")

NAMES = """
    BaseParameters DampedSolution DriveEffort DriveEstimate EquationsByParameter EquationsOfMotion ForceBounds
    ForceDerivatives JointAngles LegKinematics Linearisation LogFormat LogWarning ModelFile MotorMotion
    PathSingularities PhysicalityWarning PlatformPose angles_kept array_kernel columns_into damped_solution
    estimated_noise force_deviations force_residue forces_into forces_of_columns forces_with_bounds
    lengths_kept limits_joint_angles linearise pose_of_motors simulated_experiment singularities_along
    straight_conditions time_path weights_within_steps
"""
"""Former names of the Python interface that name nothing else."""
OPTIONS = """
    --allow-singular --angles --box --clearance --condition --drive --least --lengths --no-pictures
    --noise-angle --noise-position --noise-share --physical --picture --poses --shared --sigma --start --turns
"""
SUBCOMMANDS = "advise bench size"
FORMER = re.compile(
    rf"(?<!\w)(?:{'|'.join(NAMES.split())})\b"
    rf"|(?<![\w-])(?:{'|'.join(OPTIONS.split())})(?![\w-])"
    rf"|stewart-sym (?:{'|'.join(SUBCOMMANDS.split())})(?![\w-])"
)


@pytest.mark.slow
def test_no_file_has_a_former_name() -> None:
    inside = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.suffix not in BINARY]
    paths = [path for path in inside if path.is_file() and "_build" not in path.parts]
    assert len(paths) > 500
    found = {
        str(path): FORMER.findall(path.read_text(encoding="utf-8", errors="replace"))
        for path in (ROOT / "README.md", ROOT / "pyproject.toml", *paths)
        if path.name != Path(__file__).name
    }
    assert {path: names for path, names in found.items() if names} == {}


def test_a_former_name_is_found_where_it_is_one() -> None:
    for text in ("ss.linearise", "forces_into(", "`--no-pictures`", "stewart-sym size a.toml"):
        assert FORMER.search(text)
    for text in ("linearize", "--no-plots", "--position-std", "stewart-sym size-actuators a.toml"):
        assert not FORMER.search(text)
