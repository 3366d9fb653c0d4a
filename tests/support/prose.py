"""Rates of unclear English in docstrings, comments, messages, and pages."""

import ast
import io
import re
import tokenize
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

LONGEST_SENTENCE = 30
"""Largest number of words in a sentence."""

RULES = {
    "headless clause": r"\bwhat (?!if\b|kind\b)(?!.*\?)|^how (?:much|many|far|often)\b(?!.*\?)",
    "that of": r"\b(?:that|those) of\b|\bthose (?:that|which|with|in)\b",
    "opening with of": r"^of (?!course\b|length\b|shape\b)",
    "beside": r"\bbesides?\b",
    "vague verb": r"\b(?:says|said|stands|stood|tells|told|bears|brings|holds|leaves|wanted|sought)\b",
    "British spelling": r"\b(?:metres?|millimetres?|centres?|colours?|behaviour|neighbours?|licence|grey"
    r"|(?:linear|normal|optim|minim|maxim|initial|general|parametr)is(?:e|es|ed|ing|ation))\b",
}
"""Pattern of each rule, searched in every sentence without regard to case."""

_MARKUP = re.compile(r"`+[^`]+`+|\$[^$]+\$|!?\[(?=[^\]]*\]\()|\]\([^)]*\)|\*\*|https?://\S+")
_SENTENCE_END = re.compile(r"(?<=[.!?])[\"')]?\s+(?=[\"'(]?[A-Z])")
_ENTRY = re.compile(r"\s*(?:[-*+]|\d+\.|#+|>)\s+")
_SECTION_LINE = re.compile(r"\s*-{3,}\s*$")


def count_findings(passages: Iterator[str]) -> Counter[str]:
    """Count words, sentences that are too long, and findings of each rule."""
    counts: Counter[str] = Counter()
    for passage in passages:
        plain = _MARKUP.sub(lambda match: "X" if match[0][0] in "`$" else "", " ".join(passage.split()))
        for sentence in _SENTENCE_END.split(plain):
            words = len(re.findall(r"[A-Za-z][\w'-]*", sentence))
            counts["words"] += words
            counts["long sentence"] += words > LONGEST_SENTENCE
            for rule, pattern in RULES.items():
                counts[rule] += len(re.findall(pattern, sentence, re.IGNORECASE))
    return counts


def rates(counts: Counter[str]) -> dict[str, float]:
    """Return the findings of each rule per 1000 words."""
    return {rule: 1000 * counts[rule] / max(counts["words"], 1) for rule in (*RULES, "long sentence")}


def page_passages(page: Path) -> Iterator[str]:
    """Yield paragraphs, list entries, and table cells of a Markdown page, without code and directives."""
    text = re.sub(
        r"^(```+|~~~+|:::+|\$\$)[\s\S]*?^\1\s*$", "\n", page.read_text(encoding="utf-8"), flags=re.M
    )
    text = re.sub(r"<!--[\s\S]*?-->", "", text)
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*(?:[-*+]|\d+\.|#+|\|)\s)", text):
        if paragraph.lstrip().startswith("|"):
            yield from re.split(r"[|\n]", paragraph)
        else:
            yield _ENTRY.sub("", paragraph, count=1)


def code_passages(module: Path) -> Iterator[str]:
    """Yield the paragraphs of docstrings and the comments of a module."""
    source = module.read_text(encoding="utf-8")
    for node in ast.walk(ast.parse(source)):
        for statement in getattr(node, "body", []) if not isinstance(node, ast.Lambda | ast.IfExp) else []:
            value = getattr(statement, "value", None) if isinstance(statement, ast.Expr) else None
            if isinstance(value, ast.Constant) and isinstance(value.value, str):
                yield from _docstring_passages(value.value)
    yield from _comments(source)


def message_passages(module: Path) -> Iterator[str]:
    """Yield the texts of raised errors and of warnings in a module; formatted values count as one word."""
    tree = ast.parse(module.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        call = node.exc if isinstance(node, ast.Raise) else node
        is_message = isinstance(node, ast.Raise) or (
            isinstance(call, ast.Call) and ast.unparse(call.func).endswith("warn")
        )
        if is_message and isinstance(call, ast.Call):
            for argument in call.args:
                yield from _texts(argument)


def _docstring_passages(docstring: str) -> Iterator[str]:
    """Yield the paragraphs of a docstring without examples and without titles of sections."""
    body = re.split(r"\n\s*Examples\n\s*-{3,}", docstring)[0]
    lines = body.splitlines()
    titles = {index - 1 for index, line in enumerate(lines) if _SECTION_LINE.match(line)}
    kept = ["" if index in titles or _SECTION_LINE.match(line) else line for index, line in enumerate(lines)]
    # The name and the type of a parameter are a paragraph of their own.
    yield from re.split(r"\n\s*\n|\n(?=\s*\w[\w, *]* : )|(?<= : )", "\n".join(kept))


def _comments(source: str) -> Iterator[str]:
    """Yield blocks of comments without pragmas."""
    block: list[str] = []
    last = -1
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT and not re.match(r"#\s*(?:noqa|type:|mypy|fmt)", token.string):
            if token.start[0] != last + 1:
                yield " ".join(block)
                block = []
            block.append(token.string.lstrip("# "))
            last = token.start[0]
    yield " ".join(block)


def _texts(argument: ast.expr) -> Iterator[str]:
    """Yield the strings within an argument."""
    if isinstance(argument, ast.JoinedStr):
        yield "".join(str(part.value) if isinstance(part, ast.Constant) else "X" for part in argument.values)
    elif isinstance(argument, ast.Constant) and isinstance(argument.value, str):
        yield argument.value
    else:
        for child in ast.iter_child_nodes(argument):
            if isinstance(child, ast.expr):
                yield from _texts(child)
