"""Code, messages, kits and pages are written in the field's terms: no file has one of the private words."""

import re
from pathlib import Path

from stewart_sym.cli import renamed

ROOT = Path(__file__).parents[2]
FOLDERS = ("derive", "generated", "stewart_sym", "tests", ".ci", ".docs")
TEXTS = {
    *(".py", ".pyi", ".c", ".h", ".in", ".md", ".toml", ".cmake", ".json", ".ipynb", ".sh", ".m", ".rs", ""),
}

# What such a word has in it in small letters, pattern of what is not written, and what is.
WORDS = (
    (("a pose",), r"(?i:ns a pose|operations of a pose)", "ns per pose, operations per pose"),
    (("verb",), r"\bverbs?\b", "subcommand"),
    (("road",), r"\broads?\b", "code path"),
    (("pole",), r"\bpoles?\b|(?<![a-z])[Pp]oles?_|_poles?\b|_POLE\b", "joint singularity"),
    (("short leg", "short_leg"), r"\b[Ss]hort leg\b|SHORT_LEG", "zero-length leg"),
    (("know",), r"\bknows?(?: (?:nothing|no)\b)|\bKnows\b", "does not depend on"),
    (("stand",), r"\b[Ss]tands? (?:beside|above|below)\b", "(delete)"),
    (("told", "asks"), r"\b(?:is|are|was) told\b|\basks\b", "is given, calls"),
    (("refus",), r"\b[Rr]efus(?:e|es|ed|al|als|ing)\b", "reject"),
    (("answer",), r"(?:pose|poses) without an answer|ha(?:s|ve) no answer", "unsolvable pose"),
    (("walk",), r"\bwalks? into\b", "approach a degenerate configuration"),
    (("atlas",), r"\b[Aa]tlas\b", "study, sweep"),
    (("judg",), r"\b[Jj]udg(?:e|es|ed|ing|ements?)\b", "check, oracle"),
    (("alarmed",), r"\balarmed\b", "false alarm"),
    (("rounding",), r"rounding (?:does|put)\b", "rounding error, error bound"),
    (
        ("told", "weighed"),
        r"can(?:'t)? be told\b|weighed by moving",
        "identifiable, identified from motion data",
    ),
    (
        ("notices", "lost motion"),
        r"\bno leg notices\b|\blost motions?\b",
        "twist that changes no leg length, unconstrained twist",
    ),
    (("freedoms",), r"\bfreedoms\b", "degrees of freedom"),
    (("all round",), r"(?:alike|the same) all round", "axisymmetric"),
    (
        ("goes with", "mirrors", "bits"),
        r"\bgoes with\b|\bmirrors\b|keeps? (?:its|their) bits",
        "applies to, is a reflection of, bit-identical",
    ),
    (("contestant", "peer"), r"\b[Cc]ontestants?\b|\b[Pp]eers?\b", "candidate, baseline"),
    (("passage",), r"\bpassages?\b", "singularities along a path"),
    (("economy",), r"\b[Ee]conomy\b", "cost and accuracy"),
    (
        ("riding", "rides", "rub"),
        r"\b[Rr]iding\b|\brides\b|\brub(?:s|bed)?\b",
        "lumped mass, and names of the physical quantity",
    ),
)
"""Private words and the field's terms in their place; the letters spare most lines the slower search."""


LISTS = (Path(__file__).name, "prose.py")
"""Names of files that contain words to be found."""


def files() -> list[Path]:
    """Texts of the repository that people wrote or read, those with lists of words aside."""
    inside = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.is_file()]
    kept = [
        path for path in inside if path.suffix in TEXTS and not {"__pycache__", "_build"} & set(path.parts)
    ]
    return [ROOT / "README.md", ROOT / "pyproject.toml", *(path for path in kept if path.name not in LISTS)]


def found_in(text: str) -> list[tuple[int, str, str]]:
    """Lines with private words: number, line, what is expected."""
    small = text.lower()
    return [
        (number, line.strip()[:100], term)
        for letters, private, term in WORDS
        if any(each in small for each in letters)
        for number, line in enumerate(text.splitlines(), 1)
        if any(each in line.lower() for each in letters) and re.search(private, line)
    ]


def test_no_file_has_a_private_word_in_place_of_the_term() -> None:
    texts = {path: path.read_text(encoding="utf-8", errors="replace") for path in files()}
    assert len(texts) > 700
    found = {str(path.relative_to(ROOT)): found_in(text) for path, text in texts.items()}
    assert {path: lines for path, lines in found.items() if lines} == {}


def test_a_private_word_is_found_with_its_line_and_the_term() -> None:
    assert found_in("one\nwhat it " + "ref" + "uses\n") == [(2, "what it " + "ref" + "uses", "reject")]


CODE = (
    "BaseParameters|DampedSolution|DriveEffort|DriveEstimate|EquationsByParameter|EquationsOfMotion|ForceBounds"
    "|ForceDerivatives|JointAngles|LegKinematics|Linearisation|LogFormat|LogWarning|ModelFile|MotorMotion"
    "|PathSingularities|PhysicalityWarning|PlatformPose|angles_kept|array_kernel|columns_into|damped_solution"
    "|estimated_noise|force_deviations|force_residue|forces_into|forces_of_columns|forces_with_bounds"
    "|lengths_kept|limits_joint_angles|linearise|pose_of_motors|simulated_experiment|singularities_along"
    "|straight_conditions|time_path|weights_within_steps"
)
"""Former names in code that nothing else has."""
FORMER = re.compile(
    rf"(?<!\w)(?:{CODE})\b"
    rf"|(?<![\w-])(?:{'|'.join(renamed.OPTIONS)})(?![\w-])"
    rf"|stewart-sym (?:{'|'.join(renamed.SUBCOMMANDS)})(?![\w-])"
)
TABLES = ("renamed.py", "test_renamed.py", "test_former_names.py")
"""Names of files that list former names."""


def test_no_file_has_a_former_name() -> None:
    texts = {path: path.read_text(encoding="utf-8", errors="replace") for path in files()}
    found = {str(path): FORMER.findall(text) for path, text in texts.items() if path.name not in TABLES}
    assert {path: names for path, names in found.items() if names} == {}


def test_a_former_name_is_found_where_it_is_one() -> None:
    for text in ("ss.linearise", "forces_into(", "`--no-pictures`", "stewart-sym size a.toml"):
        assert FORMER.search(text)
    for text in ("linearize", "--no-plots", "--position-std", "stewart-sym size-actuators a.toml"):
        assert not FORMER.search(text)
