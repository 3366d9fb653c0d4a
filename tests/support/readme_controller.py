"""The README's part about microcontrollers, as Markdown made of what ``stewart-sym controller`` wrote.

``test_readme`` compares it with the README and, run as a program, writes it there.
"""

from typing import Any

from readme_bench import paragraph, table

BEGIN = "<!-- from .docs/controller.json by `PYTHONPATH=tests/support python tests/cli/test_readme.py` -->\n"
END = "<!-- end of controller -->\n"

Figures = dict[str, Any]


def replaced(readme: str, found: Figures) -> str:
    """The README with the part between the marks made anew from the figures."""
    before, _, rest = readme.partition(BEGIN)
    _, _, after = rest.partition(END)
    assert after, "the README's marks of controller are gone"
    return f"{before}{BEGIN}\n{text(found)}{END}{after}"


def text(found: Figures) -> str:
    """Everything between the marks."""
    return "".join([conditions(found), figures(found["rows"]), remarks(found["rows"])])


def conditions(found: Figures) -> str:
    compiler, emulator = found["tools"].values()
    gcc = f"{compiler.split(' (')[0]} {compiler.rsplit(') ', 1)[-1].split()[0]}"
    qemu = emulator.removeprefix("QEMU emulator version ").split(" (")[0]
    own = {row["core"]: f"`{' '.join(row['flags'])}` ({row['core']})" for row in found["rows"]}
    return paragraph(
        f"`stewart-sym controller` writes one-pose kernels for {found['robot']}, cross-compiles them with "
        f"{gcc}, `{' '.join(found['flags'])}` and {' or '.join(own.values())}, and runs them "
        f"under QEMU {qemu}, which counts instructions. The most of {found['rows'][0]['poses']} poses, one "
        "of them with a leg near its joint singularity, all within the bounds of 50-digit forces; flash, RAM "
        "and stack in bytes:"
    )


def figures(rows: list[Figures]) -> str:
    header = (
        *("kit", "processor", "instructions", "near joint singularities", "flash, kernel", "robot"),
        *("RAM, model", "stack, pose", "preparation", "error over bound"),
    )
    return table(header, [cells(row) for row in rows])


def cells(row: Figures) -> tuple[str, ...]:
    return (
        f"{'baked' if row['baked'] else 'general'}, `{row['precision']}`",
        row["core"],
        number(row["instructions"]),
        number(row["near_singular_joints"]),
        number(row["flash"]["kernel"]),
        number(row["flash"]["robot"]),
        number(row["ram"].get("model", 0)),
        number(max(row["stack"]["pose"], row["stack"]["frames"])),
        number(row["stack"].get("prepare")),
        f"{row['worst']:.3f}",
    )


def remarks(rows: list[Figures]) -> str:
    assert not any(
        row["foreign"] or row["double"] or row["failed"] or row["rejected_wrongly"] for row in rows
    )
    assert not any(row["ram"]["kit"] for row in rows)
    return paragraph(
        "Near joint singularities: all six legs within 1/1000 rad of the fixed axes of their universal "
        "joints, the longest way through the kernel. The model, prepared once, is the caller's; the kits "
        "have no data of their own. The objects need nothing of a library but square root and copies of "
        "memory; those in `float` "
        "hold no double-precision instruction."
    )


def number(value: int | None) -> str:
    return "" if value is None else f"{value:,}"
