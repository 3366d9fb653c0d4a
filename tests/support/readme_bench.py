"""The README's part about time, as Markdown made of what ``stewart-sym bench`` wrote.

``test_readme`` compares it with the README and, run as a program, writes it there.
"""

import textwrap
from collections.abc import Sequence
from typing import Any

from stewart_sym.io.extras import install

BEGIN = "<!-- from .docs/bench.json by `PYTHONPATH=tests/support python tests/cli/test_readme.py` -->\n"
END = "<!-- end -->\n"


def replaced(readme: str, found: dict[str, Any]) -> str:
    """The README with the part between the marks made anew from the figures."""
    before, _, rest = readme.partition(BEGIN)
    _, _, after = rest.partition(END)
    assert after, "the README's marks are gone"
    return f"{before}{BEGIN}\n{text(found)}{END}{after}"


def text(found: dict[str, Any]) -> str:
    """Everything between the marks; ValueError for a run without all that it shows."""
    if found.get("left_out"):
        missing = ", ".join(found["left_out"])
        raise ValueError(
            f"bench.json: expected figures of all software that is compared, got none of {missing}: "
            f"{install('bench')} and run `stewart-sym bench` again"
        )
    parts = [times(found), cores(found), sizes(found), calls(found)]
    if found["passes"]:
        parts.append(passes(found))
    if "motion" in found:
        parts.append(motion(found["motion"], found["rounds"]))
    return "".join([*parts, compiling(found)])


def times(found: dict[str, Any]) -> str:
    machine, compiler = found["machine"], found["software"]["compiler"]
    vectors = f" with {machine['vectors']}" if machine["vectors"] else ""
    rows = [
        (each["name"], f"{each['median']:.0f}", f"{each['ratio_to_casadi']:.2f}")
        for each in (*found["ours"], *found["baselines"])
    ]
    return paragraph(
        f"Nanoseconds a pose, `{found['formulation']}` with friction and load, printed by `stewart-sym "
        f"bench` on {machine['cores']} cores of an {machine['processor']}{vectors}, {compiler}, medians of "
        f"{found['rounds']} rounds; ratio to CasADi's C of the same equations, built with the same flags:"
    ) + table(("", "ns per pose", "ratio"), rows)


def cores(found: dict[str, Any]) -> str:
    speedup = found["cores"]
    low, high = speedup["quartiles"]
    return paragraph(
        f"{speedup['cores']} cores over one core: {speedup['median']:.2f} times (quartiles {low:.2f} to "
        f"{high:.2f}, round by round), a batch of {speedup['poses']:,} poses; multiply-adds alone "
        f"{found['cores_arithmetic']['median']:.2f} times."
    )


def sizes(found: dict[str, Any]) -> str:
    (name, flatness), *_ = found["flatness"].items()
    swept = [each for each in found["sweep"] if each["name"] == name]
    counts = [f"{each['poses']:.0e}".replace("e+0", "e") for each in swept]
    return paragraph(
        f"From {counts[0]} to {counts[-1]} poses ({name}, one call of `forces_into` each) the longest time a "
        f"pose is {flatness:.2f} times the shortest."
    ) + table(("poses", *counts), [("ns per pose", *(f"{each['median']:.0f}" for each in swept))])


def calls(found: dict[str, Any]) -> str:
    rows = [
        (f"`{call}`", f"{each['median'] / 1e3:.2f}", f"{each['overhead_over_c_ns'] / 1e3:.2f}")
        for call, each in zip(("slot.solve()", "inverse_dynamics()"), found["calls"], strict=True)
    ]
    lead = paragraph("One pose from Python, and what the call adds to the C:")
    return lead + table(("", "us per call", "us over C"), rows)


def passes(found: dict[str, Any]) -> str:
    batch = found["passes"][0]["batch"]["poses"]
    rows = [
        (
            each["name"],
            *(str(count) for count in each["operations"].values()),
            f"{each['one_pose']['median']:.0f}",
            f"{each['batch']['median']:.0f}",
        )
        for each in found["passes"]
    ]
    header = ("after the pass", "without friction", "with friction", "one pose, ns", "batch, ns")
    return paragraph(
        "What each reduction of the derivation brings, forces alone: operations, and time per pose, alone "
        f"and in batches of {batch:,} on one core:"
    ) + table(header, rows)


def motion(found: dict[str, Any], rounds: int) -> str:
    poses = found["ours"][0]["poses"]
    better = next(each for each in found["baselines"] if each["name"] == found["better_baseline"])
    agreement = " and ".join(
        f"{found['largest_difference'][each['name']]:.0e}" for each in found["baselines"]
    )
    names = " and ".join(f"{each['name']}'s `{each['what'].split(',')[0]}`" for each in found["baselines"])
    rows = [
        (
            each["name"],
            f"{each['median']:.0f}",
            f"{each['ratio_to_inverse_dynamics']:.2f}",
            ", goal ".join(f"{each[name]:g}" for name in ("target", "goal") if name in each),
        )
        for each in found["ours"]
    ]
    rows += [
        (
            f"{each['name']}, forward dynamics",
            f"{each['median']:.0f}",
            f"{each['ratio_to_inverse_dynamics']:.2f}",
            "",
        )
        for each in found["baselines"]
    ]
    lead = paragraph(
        "The closed form's functions in C (`stewart_exact_motion.h`), one pose at a time, nanoseconds a "
        f"pose, medians of the same {rounds} rounds over {poses} poses, and the ratio to inverse dynamics:"
    )
    about = paragraph(
        f"Forward dynamics is {found['times_faster']:.1f} times as fast as the better of the two baselines, "
        f"{better['name']} (target {found['target_times_faster']:g}). The baselines are {names} over all 13 "
        "bodies as a tree with five points closed by constraints, same load and friction, called from "
        "Python, less a call over a model without bodies; their state and generalised forces are given to "
        f"them, and their accelerations agree with ours to {agreement} of a pose's largest (MuJoCo's "
        "constraints give way; their springs hold with the loops open by "
        f"{1e9 * found['loops_open_m']:.0f} nm). The paper's inertia tensors belong to no body and MuJoCo "
        "takes none like them: all of this table has tensors near them that bodies can have."
    )
    picture = "![Equations of motion, time per pose](.docs/bench_motion.png)\n\n"
    return lead + table(("", "ns per pose", "ratio", "at most"), rows) + about + picture


def compiling(found: dict[str, Any]) -> str:
    seconds = " and ".join(f"`{each['source']}` in {each['median']:.2f} s" for each in found["compiling"])
    line = f"At the benchmark's flags the compiler builds {seconds}."
    size = found["text"]
    if size is not None:
        line += (
            " A program that prepares a robot and computes one pose at a time is left with "
            f"{size['total']:,} bytes of machine code ({found['machine']['architecture']}, "
            f"`{' '.join(size['flags'])}`, linked with `--gc-sections`)."
        )
    return paragraph(line)


def paragraph(line: str) -> str:
    return textwrap.fill(line, 110, break_on_hyphens=False, break_long_words=False) + "\n\n"


def table(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [header, ["---"] * len(header), *rows]
    return "".join(f"| {' | '.join(cells)} |\n".replace("|  |", "| |") for cells in lines) + "\n"
