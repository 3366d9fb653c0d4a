"""C files of the studies, and loops that call a function for one pose after the other."""

from importlib.resources import files


def loop_source(
    header: str, body: str, pose: str = "stewart_motion", number: str = "stewart_real"
) -> dict[str, str]:
    """C of the ``drive`` that ``c_loop`` calls: file name -> text.

    body: of the function of ``machine``, ``motion`` and ``F`` that puts one pose's forces into F and returns
    a status; pose, number: types of the last two.
    """
    call = (
        f'#include <string.h>\n#include "{header}"\n#define POSE {pose}\n#define NUMBER {number}\n'
        f"static int call(const void *machine, const POSE *motion, NUMBER *F)\n{{\n{body}\n}}\n"
    )
    return {"loop.c": own_source("loop.c"), "call.h": call}


def own_source(name: str) -> str:
    """A C file of this package."""
    return (files(__package__) / name).read_text(encoding="utf-8")
