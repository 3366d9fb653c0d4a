"""Order of loads and steps in a function."""

from collections.abc import Iterable

from . import nodes as t


def where_read(
    loaded: Iterable[t.Statement], steps: Iterable[t.Statement]
) -> tuple[tuple[t.Statement, ...], tuple[t.Statement, ...]]:
    """Return the steps, with each load before the first step that reads it, and the loads that no step reads.

    Steps are grouped from comment to comment, and all components of a quantity are loaded together. Otherwise
    processors with few registers would store a loaded value and read it again.
    """
    waiting: dict[t.Expression, list[t.Let]] = {}
    for each in loaded:
        assert isinstance(each, t.Let)
        place = each.value.array if isinstance(each.value, t.Element) else each.value
        waiting.setdefault(place, []).append(each)
    runs: list[list[t.Statement]] = [[]]
    for step in steps:
        runs += [[]] if isinstance(step, t.Comment) else []
        runs[-1].append(step)
    found: list[t.Statement] = []
    for run in runs:
        read_here = {each.name for each in t.names_in(run)}
        for place in [place for place, lets in waiting.items() if read_here & {each.name for each in lets}]:
            found += waiting.pop(place)
        found += run
    return tuple(found), tuple(each for lets in waiting.values() for each in lets)
