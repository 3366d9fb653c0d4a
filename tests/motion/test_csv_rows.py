"""Rows of plain decimal numbers: the same numbers as by Python; other rows are left to the slower reader."""

import numpy as np
import pytest

from stewart_sym.motion.csv_table import _plain_numbers


@pytest.mark.parametrize(("delimiter", "decimal"), [(",", "."), (";", ","), ("\t", ".")])
def test_decimal_numbers_are_the_nearest_doubles(delimiter: str, decimal: str) -> None:
    rng = np.random.default_rng(0)
    rows = [[f"{x:.{rng.integers(1, 9)}f}" for x in rng.normal(0.0, 1e3, 4)] for _ in range(500)]
    text = "\n".join(delimiter.join(row) for row in rows).replace(".", decimal)
    found = _plain_numbers(text, delimiter, decimal, 4)
    np.testing.assert_array_equal(found, np.array(rows, dtype=float))


@pytest.mark.parametrize(
    "text",
    [
        *("1,2\n1,,2", "1,2\n,2", "1,2\n2,", "1,2\n-,3", "1.5,2\n.,3", "1,2\n--1,2", "1,2\n1-2,3"),
        *("1.5,2\n1-.5,3", "1.5,2\n1.-5,3", "1,2\n1e3,4", "1,2\n1 ,2", "1,2\n\n3,4", "1,2\n#3,4"),
        *("1,2\n3,4,5", "1.2.3,4", "1,2\n12345678901234567,3", "1,2\n99999999999999999999,3", "a,2", ""),
    ],
)
def test_other_rows_are_no_plain_numbers(text: str) -> None:
    assert _plain_numbers(text, ",", ".", 2) is None
