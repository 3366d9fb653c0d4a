"""Code, messages, kits and pages are written in the field's terms: no file has one of the private words."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
FOLDERS = ("derive", "generated", "stewart_sym", "tests", ".ci", ".docs")
TEXTS = {
    ".py",
    ".pyi",
    ".c",
    ".h",
    ".in",
    ".md",
    ".toml",
    ".cmake",
    ".json",
    ".ipynb",
    ".sh",
    ".m",
    ".rs",
    "",
}

# Left: what is not written. Right: what is.
WORDS = {
    r"(?i:ns a pose|operations of a pose)": "ns per pose, operations per pose",
    r"\bverbs?\b": "subcommand",
    r"\broads?\b": "code path",
    r"\bpoles?\b|(?<![a-z])[Pp]oles?_|_poles?\b|_POLE\b": "joint singularity",
    r"\b[Ss]hort leg\b|SHORT_LEG": "zero-length leg",
    r"\bknows?(?: (?:nothing|no)\b)|\bKnows\b": "does not depend on",
    r"\b[Ss]tands? (?:beside|above|below)\b": "(delete)",
    r"\b(?:is|are|was) told\b|\basks\b": "is given, calls",
    r"\b[Rr]efus(?:e|es|ed|al|als|ing)\b": "reject",
    r"(?:pose|poses) without an answer|ha(?:s|ve) no answer": "unsolvable pose",
    r"\bwalks? into\b": "approach a degenerate configuration",
    r"\b[Aa]tlas\b": "study, sweep",
    r"\b[Jj]udg(?:e|es|ed|ing|ements?)\b": "check, oracle",
    r"\balarmed\b": "false alarm",
    r"rounding (?:does|put)\b": "rounding error, error bound",
    r"can(?:'t)? be told\b|weighed by moving": "identifiable, identified from motion data",
    r"\bno leg notices\b|\blost motions?\b": "twist that changes no leg length, unconstrained twist",
    r"\bfreedoms\b": "degrees of freedom",
    r"(?:alike|the same) all round": "axisymmetric",
    r"\bgoes with\b|\bmirrors\b|keeps? (?:its|their) bits": "applies to, is a reflection of, bit-identical",
    r"\b[Cc]ontestants?\b|\b[Pp]eers?\b": "candidate, baseline",
    r"\bpassages?\b": "singularities along a path",
    r"\b[Ee]conomy\b": "cost and accuracy",
    r"\b[Rr]iding\b|\brides\b|\brub(?:s|bed)?\b": "lumped mass, and names of the physical quantity",
}
"""Private words and the field's terms in their place."""


def files() -> list[Path]:
    """Texts of the repository that people wrote or read, this one aside."""
    inside = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.is_file()]
    kept = [
        path for path in inside if path.suffix in TEXTS and not {"__pycache__", "_build"} & set(path.parts)
    ]
    return [ROOT / "README.md", ROOT / "pyproject.toml", *(path for path in kept if path != Path(__file__))]


def found_in(text: str) -> list[tuple[int, str, str]]:
    """Lines with private words: number, line, what is expected."""
    return [
        (number, line.strip()[:100], term)
        for private, term in WORDS.items()
        for number, line in enumerate(text.splitlines(), 1)
        if re.search(private, line)
    ]


def test_no_file_has_a_private_word_in_place_of_the_term() -> None:
    some = re.compile("|".join(f"(?:{private})" for private in WORDS))
    texts = {path: path.read_text(encoding="utf-8", errors="replace") for path in files()}
    assert len(texts) > 700
    assert {
        str(path.relative_to(ROOT)): found_in(text) for path, text in texts.items() if some.search(text)
    } == {}


def test_a_private_word_is_found_with_its_line_and_the_term() -> None:
    assert found_in("one\nwhat it " + "ref" + "uses\n") == [(2, "what it " + "ref" + "uses", "reject")]
