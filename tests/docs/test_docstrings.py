"""Docstrings of public names are complete, their examples run, and calls name their arguments."""

import dataclasses
import doctest
import functools
import inspect
from types import FunctionType
from typing import Any

import pytest
from numpydoc.docscrape import ClassDoc
from numpydoc.validate import validate

import stewart_sym as ss

FUNCTIONS = sorted(name for name in ss.__all__ if inspect.isfunction(getattr(ss, name)))
KINDS = (FunctionType, classmethod, staticmethod, property, functools.cached_property)
MAIN = [name for name in FUNCTIONS if not getattr(ss, name).__module__.startswith("stewart_sym.motion.")]
"""Functions whose docstring alone must be enough to use them; the package of motions will be replaced."""
METHODS: dict[str, Any] = {
    f"{name}.{member}": value
    for name in sorted(ss.__all__)
    if inspect.isclass(getattr(ss, name))
    for member, value in vars(getattr(ss, name)).items()
    if isinstance(value, KINDS) and not member.startswith("_")
}
RECORDS = sorted(
    name
    for name in ss.__all__
    if dataclasses.is_dataclass(getattr(ss, name)) or hasattr(getattr(ss, name), "_fields")
)
EXAMPLES: dict[str, Any] = {
    name: value
    for name, value in {
        "stewart_sym": ss,
        **{name: getattr(ss, name) for name in ss.__all__},
        **METHODS,
        **{f"robots.{name}": value for name, value in vars(ss.robots).items() if inspect.isfunction(value)},
    }.items()
    if ">>>" in (value.__doc__ or "")
}
"""Public objects whose docstrings have examples."""
COMPLETE = {"GL08", "SS03", "PR01", "RT03", "SA01", "EX01"}
"""A docstring, a summary with a full stop, parameters, results, related functions, and examples."""
CHECKED = {
    *("GL03", "GL06", "GL07", "GL08"),  # blank lines, known sections, their order, a docstring at all
    *("SS01", "SS03"),  # a summary that ends in a full stop
    *("PR01", "PR02", "PR03", "PR04", "PR07", "PR10"),  # every parameter, in order, with type and description
    *("RT01", "RT03"),  # what is returned, described
}


@pytest.mark.slow
def test_every_parameter_and_result_of_a_function_is_described() -> None:
    for name in (*FUNCTIONS, *METHODS):
        checked = CHECKED | COMPLETE if name in MAIN else CHECKED
        errors = [each for each in validate(f"stewart_sym.{name}")["errors"] if each[0] in checked]
        assert errors == [], name


def run_examples(name: str, value: object) -> str:
    """Run the examples in the docstring of an object; return the report of the failures."""
    report: list[str] = []
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE, verbose=False)
    for test in doctest.DocTestFinder(recurse=False).find(value, name, globs={}):
        runner.run(test, out=report.append)
    return "".join(report)


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_of_a_docstring_run(name: str) -> None:
    assert run_examples(name, EXAMPLES[name]) == ""


def fields(of: Any) -> set[str]:
    """Public fields that a record adds to those of its bases."""
    names = of._fields if hasattr(of, "_fields") else [field.name for field in dataclasses.fields(of)]
    return {name for name in names if not name.startswith("_") and name in inspect.get_annotations(of)}


def test_every_field_of_a_record_is_described() -> None:
    for name in RECORDS:
        of = getattr(ss, name)
        described = ClassDoc(of, config={"show_class_members": False})["Attributes"]
        assert {part.strip() for each in described for part in each.name.split(",")} == fields(of), name
        assert all(each.type and "".join(each.desc).strip() for each in described), name
