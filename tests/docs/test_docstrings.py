"""Docstrings of public names have numpydoc's sections, which name every parameter, field and result."""

import dataclasses
import functools
import inspect
from types import FunctionType
from typing import Any

import pytest
from numpydoc.docscrape import ClassDoc, FunctionDoc
from numpydoc.validate import validate

import stewart_sym as ss

FUNCTIONS = sorted(name for name in ss.__all__ if inspect.isfunction(getattr(ss, name)))
KINDS = (FunctionType, classmethod, staticmethod, property, functools.cached_property)
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
CHECKED = {
    *("GL03", "GL06", "GL07", "GL08"),  # blank lines, known sections, their order, a docstring at all
    *("SS01", "SS03"),  # a summary that ends in a full stop
    *("PR01", "PR02", "PR03", "PR04", "PR07", "PR10"),  # every parameter, in order, with type and description
    *("RT01", "RT03"),  # what is returned, described
}


@pytest.mark.parametrize("name", [*FUNCTIONS, *METHODS])
def test_every_parameter_and_result_of_a_function_is_described(name: str) -> None:
    errors = [each for each in validate(f"stewart_sym.{name}")["errors"] if each[0] in CHECKED]
    assert errors == []


@pytest.mark.parametrize("name", [name for name, of in METHODS.items() if isinstance(of, classmethod)])
def test_what_a_class_method_returns_is_described(name: str) -> None:
    # ``validate`` looks for results of functions alone.
    results = FunctionDoc(METHODS[name].__func__)["Returns"]
    assert results
    assert all(each.type and "".join(each.desc).strip() for each in results)


def fields(of: Any) -> set[str]:
    """Public fields that a record adds to those of its bases."""
    names = of._fields if hasattr(of, "_fields") else [field.name for field in dataclasses.fields(of)]
    return {name for name in names if not name.startswith("_") and name in inspect.get_annotations(of)}


@pytest.mark.parametrize("name", RECORDS)
def test_every_field_of_a_record_is_described(name: str) -> None:
    of = getattr(ss, name)
    described = ClassDoc(of, config={"show_class_members": False})["Attributes"]
    names = {part.strip() for each in described for part in each.name.split(",")}
    assert names == fields(of)
    assert all(each.type and "".join(each.desc).strip() for each in described)


def test_a_docstring_without_sections_is_found() -> None:
    codes = {code for code, _ in validate("textwrap.indent")["errors"]}
    assert {"PR01", "RT01"} <= codes & CHECKED
