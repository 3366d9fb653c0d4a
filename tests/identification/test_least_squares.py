"""Least squares by their structure: the same solutions as by the whole matrix."""

import numpy as np
import pytest

from stewart_sym.identification.least_squares import Arrow, ArrowFactors, DenseFactors, factors, solution

INSTANTS, FUNCTIONS, FEW = 80, 20, 5


def arrow(seed: int = 0) -> Arrow:
    """As of forces and poses along a spline, each instant with six functions of six coordinates."""
    rng = np.random.default_rng(seed)
    begin = np.sort(rng.integers(0, FUNCTIONS - 5, INSTANTS))
    begin[[0, -1]] = 0, FUNCTIONS - 6
    start = np.tile(np.repeat(6 * begin, 6), 2)
    local = rng.normal(size=(12 * INSTANTS, 36)) * 10.0 ** rng.uniform(-3.0, 3.0, 36)
    return Arrow(rng.normal(size=(6 * INSTANTS, FEW)), local, start, 6 * FUNCTIONS)


@pytest.mark.parametrize("seed", range(3))
def test_an_arrow_is_solved_as_its_whole_matrix_is(seed: int) -> None:
    J, rng = arrow(seed), np.random.default_rng(seed + 100)
    by_structure, whole = factors(J), factors(J.dense())
    assert isinstance(by_structure, ArrowFactors)
    assert isinstance(whole, DenseFactors)
    assert by_structure.unknowns == whole.unknowns == FEW + J.many
    y = rng.normal(size=(12 * INSTANTS, 3))
    np.testing.assert_allclose(by_structure.explained(y), whole.explained(y), atol=1e-11)
    x = whole.solve(y[:, 0])
    np.testing.assert_allclose(by_structure.solve(y[:, 0]), x, rtol=1e-9, atol=1e-12 * np.abs(x).max())
    np.testing.assert_allclose(solution(J, y[:, 0]), by_structure.solve(y[:, 0]))
    first = 6 * INSTANTS
    np.testing.assert_allclose(by_structure.shares(first), whole.shares(first), rtol=1e-10)
    np.testing.assert_allclose(by_structure.covariance(FEW), whole.covariance(FEW), rtol=1e-9, atol=1e-15)
    np.testing.assert_allclose(J @ x, J.dense() @ x)


def test_columns_that_nearly_depend_on_others_are_solved_by_the_whole_matrix() -> None:
    J = arrow()
    J.A[:, 1] = J.A[:, 0] + 1e-6 * J.A[:, 1]
    found = factors(J)
    assert isinstance(found, DenseFactors)
    x = np.arange(found.unknowns, dtype=float)
    np.testing.assert_allclose(found.solve(J @ x), x, rtol=1e-6, atol=1e-4)
