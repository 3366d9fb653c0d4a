"""Rates of unclear English in docstrings, comments, messages, and pages."""

import ast
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from itertools import chain
from pathlib import Path

LONGEST_SENTENCE = 30
"""Largest number of words in a sentence."""

RULES = {
    "headless clause": r"\bwhat (?!if\b|kind\b)(?!.*\?)|^how (?:much|many|far|often)\b(?!.*\?)",
    "that of": r"\b(?:that|those) of\b|\bthose (?:that|which|with|in)\b",
    "opening with of": r"^of (?!course\b|length\b|shape\b)",
    "beside": r"\bbesides?\b",
    "unclear word": r"\b(?:says|said|stands|stood|tells|told|bears|brings|holds|leaves|wanted|sought)\b",
    "where for if": r"^where\b(?!.*\?)"
    r"|(?<![:,]) where (?:not|needed|given|one|two|none|all|no|they|it|there|an?)\b",
    "British spelling": r"\b(?:metres?|millimetres?|centres?|colours?|behaviour|neighbours?|licence|grey"
    r"|(?:linear|normal|optim|minim|maxim|initial|general|parametr)is(?:e|es|ed|ing|ation))\b",
}
"""Pattern of each rule, searched in every sentence without regard to case."""

_MARKUP = re.compile(r"`+[^`]+`+|\$[^$]+\$|!?\[(?=[^\]]*\]\()|\]\([^)]*\)|\*\*|https?://\S+")
_SENTENCE_END = re.compile(r"(?<=[.!?])[\"')]?\s+(?=[\"'(]?[A-Z])")
_BLOCKS = ("body", "orelse", "finalbody", "handlers", "cases")
_ENTRY = re.compile(r"\s*(?:[-*+]|\d+\.|#+|>)\s+")
_COMMENT = re.compile(r"^((?:.*\s)?)#[!: ]*(?!noqa|type:|mypy|fmt)(.*)$")
_SECTION_LINE = re.compile(r"\s*-{3,}\s*$")


def count_findings(passages: Iterable[str]) -> Counter[str]:
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


@dataclass
class Texts:
    """Docstrings, comments, and messages of a module."""

    docstrings: list[str] = field(default_factory=list)
    comments: list[str] = field(default_factory=list)
    messages: list[str] = field(default_factory=list)


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
    texts = module_texts(module)
    return chain(chain.from_iterable(map(_docstring_passages, texts.docstrings)), texts.comments)


@cache
def module_texts(module: Path) -> Texts:
    """Read the texts of a module; formatted values of messages count as one word."""
    source = module.read_text(encoding="utf-8")
    texts = Texts(comments=_comments(source))
    todo: list[ast.AST] = [ast.parse(source)]
    # Statements alone are visited: there are ten times as many expressions.
    while todo:
        node = todo.pop()
        for name in _BLOCKS:
            todo += getattr(node, name, ())
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            values = (statement.value for statement in node.body if isinstance(statement, ast.Expr))
            texts.docstrings += [
                value.value
                for value in values
                if isinstance(value, ast.Constant) and isinstance(value.value, str)
            ]
        elif isinstance(node, ast.Raise | ast.Expr):
            call = node.exc if isinstance(node, ast.Raise) else node.value
            if isinstance(call, ast.Call) and (
                isinstance(node, ast.Raise) or _name(call.func).endswith("warn")
            ):
                texts.messages += [text for argument in call.args for text in _texts(argument)]
    return texts


def _name(function: ast.expr) -> str:
    """Return the last name of a called function."""
    return getattr(function, "attr", getattr(function, "id", ""))


def _docstring_passages(docstring: str) -> Iterator[str]:
    """Yield the paragraphs of a docstring without examples and without titles of sections."""
    body = re.split(r"\n\s*Examples\n\s*-{3,}", docstring)[0]
    lines = body.splitlines()
    titles = {index - 1 for index, line in enumerate(lines) if _SECTION_LINE.match(line)}
    kept = ["" if index in titles or _SECTION_LINE.match(line) else line for index, line in enumerate(lines)]
    # The name and the type of a parameter are a paragraph of their own.
    yield from re.split(r"\n\s*\n|\n(?=\s*\w[\w, *]* : )|(?<= : )", "\n".join(kept))


def _comments(source: str) -> list[str]:
    """Return blocks of comments without pragmas."""
    blocks: list[list[str]] = []
    last, is_string = -1, False
    for number, line in enumerate(source.splitlines(), 1):
        found = _COMMENT.match(line) if "#" in line and not is_string else None
        is_string ^= line.count('"""') % 2 == 1
        # An odd number of quotation marks before the sign: it is within a string.
        if found and found[1].count('"') % 2 == 0 and found[1].count("'") % 2 == 0:
            if number != last + 1 or not blocks:
                blocks.append([])
            blocks[-1].append(found[2])
            last = number
    return [" ".join(block) for block in blocks]


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
