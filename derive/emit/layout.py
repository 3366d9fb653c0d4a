"""``generated/interface.py``: the interface table as the runtime reads it."""

from collections.abc import Iterable, Mapping

from ..kernel.interface import CALLS, STATUS, STRUCTS, Member
from ..print.template import filled


def layout(models: Mapping[str, int], headers: Iterable[str], version: str) -> str:
    """The module's text; models: how many numbers each kernel's prepared model holds. headers: those that
    sources share."""
    return filled(
        "interface.py",
        version=version,
        status="\n".join(f'    "{name}": ({code}, "{text}"),' for name, code, text in STATUS),
        structs=_shapes(STRUCTS),
        outputs=_shapes({stem: call.outputs for stem, call in CALLS.items()}),
        headers="\n".join(f'    "{name}",' for name in headers),
        models="\n".join(f'    "{name}": {count},' for name, count in models.items()),
    )


def _shapes(groups: Mapping[str, Iterable[Member]]) -> str:
    return "\n".join(
        "\n".join([f'    "{name}": {{', *(f'        "{m.name}": {m.shape},' for m in members), "    },"])
        for name, members in groups.items()
    )
