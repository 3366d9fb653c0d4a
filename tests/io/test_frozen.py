"""Frozen records stay frozen: through copies, deep copies and pickles, records in records too."""

import copy
import dataclasses
import pickle
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from command_line import rejects
from machines import random_motion, random_robot

import stewart_sym as ss
from stewart_sym.io.array_types import Frozen

COPIES: dict[str, Callable[[Any], Any]] = {
    "itself": lambda record: record,
    "deepcopy of a copy": lambda record: copy.deepcopy(copy.copy(record)),
    "pickle": lambda record: pickle.loads(pickle.dumps(record)),
}


def records() -> dict[str, Frozen]:
    rng = np.random.default_rng(12)
    robot = random_robot(rng)
    return {
        "Robot": robot,
        "Motion": random_motion(rng, robot, (3,)),
        "ForceKernel": ss.ForceKernel(robot, precision="float"),
        "FourierPath": ss.FourierPath([0, 0, 1], [0, 0, 0], np.ones((2, 6)), np.ones((2, 6)), 2.0),
        "LegSprings": ss.LegSprings(robot, 1e6, 1.0, np.arange(6.0)),
    }


def arrays(record: Any, name: str = "") -> Iterator[tuple[str, np.ndarray[Any, Any]]]:
    """Arrays of a record and of the records in it."""
    for field in dataclasses.fields(record):
        value = getattr(record, field.name)
        if isinstance(value, np.ndarray):
            yield f"{name}{field.name}", value
        elif dataclasses.is_dataclass(value):
            yield from arrays(value, f"{name}{field.name}.")


@pytest.mark.parametrize("how", COPIES)
def test_no_array_of_a_frozen_record_can_be_written_to(how: str) -> None:
    for name, record in records().items():
        found = dict(arrays(COPIES[how](record)))
        assert found
        for (path, array), (_, before) in zip(found.items(), arrays(record), strict=True):
            np.testing.assert_array_equal(array, before)
            assert not array.flags.writeable, (name, path)
            rejects("WRITEABLE", array.setflags, write=True)


def test_what_a_record_was_made_of_stays_the_callers_own() -> None:
    t = np.zeros(3)
    own = ss.Motion(R=np.eye(3), t=t, omega=t, v=t)
    t[0] = 1.0
    assert own.t[0] == 0.0
    # A shallow copy of a motion made for an inner loop must not close the caller's arrays.
    t = np.zeros(3)
    loose = ss.Motion._unchecked(np.eye(3), t, t.copy(), t.copy())
    assert not copy.copy(loose).t.flags.writeable
    t[0] = 1.0
    assert loose.t[0] == 1.0
