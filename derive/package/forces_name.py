"""Header of a kit that gives the forces one name, with and without baked constants."""

from .functions import MODEL, Function
from .robot_source import HEADER, Machine
from .text_format import in_comment, template

FORCES_HEADER = "stewart_kit.h"
"""File name of the header."""


def forces_header(machine: Machine, function: Function) -> dict[str, str]:
    """Return the header of the forces by its file name; ``function`` is the function of the forces."""
    of_model = function.subject == MODEL
    own = ('#include "stewart.h"', f'#include "{HEADER}"', f'#include "{function.header}"')
    words = {
        "name": in_comment(machine.name),
        "version": machine.version,
        "includes": "\n".join(own if of_model else (own[0], own[2])),
        "unused": "" if of_model else ", which are in the kernel; the model is empty",
        "model": f"{function.prefix}_model" if of_model else "struct { char unused; }",
        "prepare": f"return {function.prefix}_prepare(&{machine.symbol}, model);"
        if of_model
        else "model->unused = 0;\n    return STEWART_OK;",
        "symbol": function.symbol,
        "subject": "model, " if of_model else "",
        "ignored": "" if of_model else "(void)model;\n    ",
    }
    batch = template("kit/stewart_kit_batch.h", words) if function.batch else ""
    return {FORCES_HEADER: template("kit/stewart_kit.h", words | {"batch": batch})}
