"""Report of ``benchmark``: tables for the terminal, and plots."""

import functools
import math
import textwrap
from collections.abc import Sequence
from typing import Any

from ...io.extras import install
from ..common.drawing import BLUE, RED, Axes, new_figure
from ..common.drawing import Figure as Canvas
from ..common.host import DISTURBED
from ..common.output import Figures, aligned
from ..common.report import SMALL, Picture, Report
from .figures import CLOSED, MOST, PLAIN, named, ratios

WIDTH = 110

_OURS, _PEER, _LIMIT = BLUE, "#5a5a5a", RED
_SOFTWARE = {
    "casadi": "CasADi",
    "pin": "Pinocchio",
    "drake": "Drake",
    "mujoco": "MuJoCo",
    "jax": "JAX",
    "numpy": "NumPy",
    "python": "Python",
}
_MARKERS, _COLORS = "osD", (_OURS, "#7a9cc6", "#2e7d32")


# --- tables -----------------------------------------------------------------------------------


def report(found: Figures) -> str:
    """Format all results with units and conditions as one text."""
    machine, software = found["machine"], found["software"]
    sets = ", ".join(machine["instruction_sets"]) or "unknown instruction sets"
    head = [
        f"Inverse dynamics of {found['robot']}, exact, one pose: F with friction, load and solve",
        "",
        f"{machine['processor']}, {machine['cores']} cores, {sets}; {software['compiler']}",
        *_others(machine["taken_by_others"]),
        " ".join(software["flags"]),
        ", ".join(f"{name} {software[key]}" for key, name in _SOFTWARE.items() if key in software),
    ]
    if found["left_out"]:
        missing = ", ".join(found["left_out"])
        head.append(f"not installed and left out: {missing}; {install('bench')}")
    parts = ["\n".join(head), _shares(found), _candidates(found), _cores(found), _notes(found)]
    parts += [_builds(found), _calls(found), _sizes(found), _motion(found["motion"])]
    if found["passes"]:
        parts.append(_passes(found))
    parts.append(_compiling(found))
    return "\n\n".join(parts) + "\n"


def _others(share: float | None) -> list[str]:
    """Describe the disturbance by other processes; nothing if the system does not provide it."""
    if share is None:
        return []
    verdict = ": the figures are disturbed, above all those of several cores" if share > DISTURBED else ""
    return [f"other processes took {100 * share:.0f} % of the cores' time{verdict}"]


def _shares(found: Figures) -> str:
    """Format the ratios with targets, with a column for each kind of instructions."""
    kinds = [peak["instructions"] for peak in found["peaks"]]
    rows = []
    for each in found["shares"]:
        values = (f"{each['values'][kind]:#.3g}" if kind in each["values"] else "" for kind in kinds)
        bound = f"{each['at_most']:g}" if "at_most" in each else ""
        bound = f"at least {each['at_least']:g}" if "at_least" in each else bound
        goal = f"{each['goal']:g}" if "goal" in each else ""
        rows.append((each["name"], each["unit"], *values, bound, goal))
    return aligned(("shares", "", *kinds, "at most", "goal"), rows, left=2)


def _candidates(found: Figures) -> str:
    header = ("code", "poses", "ns", "cycles", "quartiles, ns", *_peers(found), "vectors")
    rows = [_row(found, figure, f"ours: {figure['name']}") for figure in found["ours"]]
    rows += [_row(found, figure, figure["name"]) for figure in found["baselines"]]
    rows += [
        (name, "", *_times_of(found, value), "", *_ratios(found, value), found["peaks"][0]["instructions"])
        for name, value in found["peaks"][0]["limits"].items()
    ]
    return aligned(header, rows)


def _row(found: Figures, figure: Figures, name: str) -> tuple[str, ...]:
    loop = {"one pose": "1, C loop", "call": "1"}.get(figure["kind"], str(figure["poses"]))
    time = figure["median"]
    over = _ratios(found, time)
    return name, loop, *_times_of(found, time), _spread(figure), *over, figure.get("vectors", "")


def _peers(found: Figures) -> tuple[str, ...]:
    """Return the headings of ``_ratios``."""
    return ("x closed", "x CasADi") if "ratio_to" in found else ()


def _times_of(found: Figures, time: float) -> tuple[str, str]:
    return _number(time), f"{time / found['cycle']['median']:.0f}"


def _ratios(found: Figures, time: float, target: str = "") -> tuple[str, ...]:
    """Format ratios to the times of CasADi's closed form and plain C; nothing without CasADi."""
    return tuple(f"{ratio:.3f}" for ratio in ratios(found, time, target).values())


def _builds(found: Figures) -> str:
    """Format all C code with instructions and flags; ratios are to CasADi's C for the same instructions."""
    header = ("C by instructions and flags", "vectors", "operations", "ns", "cycles", *_peers(found))
    own = {peak["instructions"]: peak["flags"] for peak in found["peaks"]}
    rows = [
        (
            " ".join((each["name"], *each["flags"][len(own[each["instructions"]]) :])),
            each["vectors"],
            _count(each),
            *_times_of(found, each["median"]),
            *_ratios(found, each["median"], each["instructions"]),
        )
        for each in found["builds"]
    ]
    operations = found["ours"][0]["operations"]
    for peak in found["peaks"]:
        for name, value in peak["limits"].items():
            over = _ratios(found, value, peak["instructions"])
            rows.append((name, peak["instructions"], str(operations), *_times_of(found, value), *over))
    without = [f"{target} with {' '.join(flags)}. " for target, flags in own.items() if flags]
    notes = (
        f"{''.join(without)}Flags come after those above. Vectors: the widest that the machine code computes "
        "with, where objdump tells."
    )
    if _peers(found):
        notes += " Ratios are to the faster of CasADi's builds for the same instructions."
    return f"{aligned(header, rows, left=2)}\n\n{_filled(notes)}"


def _cores(found: Figures) -> str:
    cores = found["cores"]
    low, high = cores["quartiles"]
    return (
        f"{cores['cores']} cores over one core: {cores['median']:.2f} times, quartiles {low:.2f} - "
        f"{high:.2f}; {cores['poses']} poses, round by round;\nmultiply-adds alone, which is what the "
        f"machine had to give: {found['cores_arithmetic']['median']:.2f} times"
    )


def _notes(found: Figures) -> str:
    worst = max(found["largest_difference"].values())
    return _filled(
        f"Medians and quartiles of {found['rounds']} rounds; in each round every code takes its turn, for "
        f"{1e3 * found['shortest_sample_s']:g} ms or more, after a run of its own that isn't timed. Ratios "
        f"are of medians. All found the same forces first, to {worst:.0e} of a pose's largest. "
        f"{_casadi_note(found)}{_called_note(found)}{_limit_note(found)}"
    )


def _casadi_note(found: Figures) -> str:
    closed, plain = (named(found["baselines"], name) for name in (CLOSED, PLAIN))
    if closed is None or plain is None:
        return ""
    return (
        "CasADi: the same equations written plainly, in vectors, or as the closed form in the leg frame, its "
        "cse() and its solve(), same compiler and flags, called from the same kind of C loop; it gives F "
        "alone and checks nothing. Each is compiled with products and sums fused by the compiler as well, "
        f"and the faster counts: {_flags(closed)} for the closed form, {_flags(plain)} for the "
        "plain one. "
    )


def _flags(figure: Figures) -> str:
    return " ".join(figure["flags"]) or "the common flags"


def _called_note(found: Figures) -> str:
    """Describe the parts of the times of baselines that are called from Python."""
    made = []
    for name, parts in found["parts"].items():
        *added, less = ((part["name"], _number(part["median"])) for part in parts)
        made.append(f"{name} {' + '.join(map(' '.join, added))} - {less[1]}")
    if not made:
        return ""
    gravity = ", gravity to Drake too" if "Drake" in found["parts"] else ""
    return (
        "Called from Python, less a call over nothing, ns: " + "; ".join(made) + ". Engines of rigid bodies "
        "compute over the tree of all 13 bodies, then LAPACK solves; joint angles, rates, accelerations, "
        f"friction, load and Jacobians are given to them{gravity}. "
    )


def _limit_note(found: Figures) -> str:
    peak = found["peaks"][0]
    return (
        f"Cycles: of a clock of {found['cycle']['clock_GHz']:.2f} GHz, one for each addition of a dependent "
        f"chain timed in the same rounds. Limit: {_count(found['ours'][0])} operations / "
        f"{peak['numbers_in_a_vector']} numbers in a vector / {peak['vectors_in_a_cycle']:.2f} vectors in a "
        "cycle, the rate of fused multiply-adds in the same rounds; "
        "divisions and roots count as any other; each operation fills the place of one multiply-add, or "
        "two of them one."
    )


def _calls(found: Figures) -> str:
    header = ("one pose from Python", "us per call", "quartiles", "us over C")
    rows = [
        (
            figure["name"],
            f"{figure['median'] / 1e3:.2f}",
            " - ".join(f"{value / 1e3:.2f}" for value in figure["quartiles"]),
            f"{figure['overhead_over_c_ns'] / 1e3:.2f}",
        )
        for figure in found["calls"]
    ]
    return aligned(header, rows)


def _sizes(found: Figures) -> str:
    sizes = sorted({figure["poses"] for figure in found["sweep"]})
    names = dict.fromkeys(figure["name"] for figure in found["sweep"])
    medians = {(figure["name"], figure["poses"]): _number(figure["median"]) for figure in found["sweep"]}
    counts = (f"{size:.0e}".replace("e+0", "e") for size in sizes)
    header = ("ns per pose, batch of", *counts, "longest/shortest")
    rows = [
        (
            f"ours: {name}",
            *(medians.get((name, size), "") for size in sizes),
            f"{found['flatness'][name]:.2f}",
        )
        for name in names
    ]
    rounds = {figure["poses"]: len(figure["raw"]) for figure in found["sweep"]}
    rows.append(("rounds", *(str(rounds[size]) for size in sizes), ""))
    return aligned(header, rows)


def _motion(found: Figures) -> str:
    header = ("equations of motion, one pose in a C loop", "ns per pose", "quartiles", "x inverse", "target")
    rows = [(f"ours: {each['name']}", *_motion_cells(each)) for each in found["ours"]]
    rows += [(f"{each['name']}, {each['what']}", *_motion_cells(each)) for each in found["baselines"]]
    return "\n\n".join(filter(None, [aligned(header, rows), _faster(found), _motion_notes(found)]))


def _motion_cells(figure: Figures) -> tuple[str, ...]:
    target = ", goal ".join(f"{figure[limit]:g}" for limit in ("target", "goal") if limit in figure)
    ratio = f"{figure['ratio_to_inverse_dynamics']:.2f}"
    return _number(figure["median"]), _spread(figure), ratio, target


def _faster(found: Figures) -> str:
    """Compare forward dynamics with the faster baseline; empty without baselines."""
    if "better_baseline" not in found:
        return ""
    better = found["better_baseline"]
    which = f"the better of the two, {better}" if len(found["baselines"]) > 1 else better
    target = f"(target {found['target_times_faster']:g})"
    return f"forward dynamics: {found['times_faster']:.1f} x faster than {which} {target}"


def _motion_notes(found: Figures) -> str:
    ours = max(found["largest_difference"][each["name"]] for each in found["ours"])
    return _filled(
        f"{found['robot']} with inertia tensors that bodies can have, for everybody here; same "
        f"rounds and turns, {found['ours'][0]['poses']} poses. All were compared with the vector reference "
        f"and its differences first, ours to {ours:.0e} of a pose's largest number."
        f"{_baselines_note(found)}{_opened_note(found)}"
    )


def _baselines_note(found: Figures) -> str:
    if not found["baselines"]:
        return ""
    taken = ", ".join(
        f"{call['name']} {_number(call['median'])} less {_number(empty['median'])} ns"
        for call, empty in zip(found["calls"], found["empty_calls"], strict=True)
    )
    differences = found["largest_difference"]
    baselines = ", ".join(f"{each['name']} {differences[each['name']]:.0e}" for each in found["baselines"])
    return (
        " Baselines: forward dynamics over a tree of all 13 bodies, five points closed by constraints, same "
        "friction, load and gravity; called from Python, less a call over a model without bodies "
        f"({taken}); joint coordinates, rates and generalized forces are given to them. Their accelerations "
        f"agree with the motion's to {baselines} of a pose's largest."
    )


def _opened_note(found: Figures) -> str:
    if "loops_open_m" not in found:
        return ""
    return (
        " MuJoCo's constraints are the stiffest it has and still give way: their springs make up for it, "
        f"with the loops open by {1e9 * found['loops_open_m']:.0f} nm."
    )


def _passes(found: Figures) -> str:
    batch = f"batch of {found['passes'][0]['batch']['poses']}"
    counts = ("operations", "with friction")
    header = ("after the pass", *counts, "one pose, ns", "quartiles", batch, "quartiles")
    rows = [
        (
            each["name"],
            *map(str, each["operations"].values()),
            _number(each["one_pose"]["median"]),
            _spread(each["one_pose"]),
            _number(each["batch"]["median"]),
            _spread(each["batch"]),
        )
        for each in found["passes"]
    ]
    meanings = "\n".join(f"{each['name']}: {each['meaning']}" for each in found["passes"])
    return f"{aligned(header, rows)}\n\n{meanings}"


def _compiling(found: Figures) -> str:
    header = ("compiling and size", "", "quartiles", "")
    flags = " ".join(found["software"]["flags"])
    rows = [
        (
            each["source"],
            f"{each['median']:.2f} s",
            " - ".join(f"{value:.2f}" for value in each["quartiles"]),
            f"median of {len(each['raw'])}",
        )
        for each in found["compiling"]
    ]
    notes = f"Compiled past the cache with {flags}."
    text = found["text"]
    if text is not None:
        parts = ", ".join(f"{name} {size}" for name, size in text["functions"].items())
        rows.append(("text for one pose", f"{text['total']} bytes", "", ""))
        notes += (
            f" Text: functions of {text['source']} that a program which prepares a robot and computes one "
            f"pose is left with ({parts}), {' '.join(text['flags'])}, linked with --gc-sections."
        )
    return f"{aligned(header, rows)}\n\n{_filled(notes)}"


def _filled(notes: str) -> str:
    return textwrap.fill(notes, WIDTH, break_on_hyphens=False)


def _count(figure: Figures) -> str:
    return "" if figure["operations"] is None else str(figure["operations"])


def _spread(figure: Figures) -> str:
    return " - ".join(map(_number, figure["quartiles"]))


def _number(value: float) -> str:
    return f"{value:.1f}" if value < 1000 else f"{value:.0f}"


# --- the picture ------------------------------------------------------------------------------


def full_report(found: Figures) -> Report:
    """Create the report with all results as tables, JSON data, and plots."""
    drawn = {"bench": picture, "bench_motion": motion_picture}
    figures = {
        name: Picture(functools.partial(draw, found), SMALL, ("png", "svg")) for name, draw in drawn.items()
    }
    return Report(report(found), data=found, figures=figures)


def picture(found: Figures) -> Canvas:
    """Plot the time of every candidate on a logarithmic axis with ratios to CasADi, and the time over batch
    size.
    """
    rows = len(found["ours"]) + len(found["baselines"])
    heights = [0.36 * rows + 1.0, 2.3]
    canvas = new_figure(8.6, sum(heights) + 0.7)
    canvas.set_layout_engine("constrained", w_pad=0.12, h_pad=0.06)
    above, below = canvas.subplots(2, 1, height_ratios=heights)
    processor = found["machine"]["processor"]
    canvas.suptitle(f"Inverse dynamics of a Stewart platform, ns per pose: {processor}", x=0.5)
    _draw_candidates(above, found)
    _draw_sizes(below, found)
    return canvas


def _draw_candidates(axes: Axes, found: Figures) -> None:
    rows = [(figure, f"ours: {_named(figure)}", _OURS) for figure in found["ours"]]
    rows += [(figure, _named(figure), _PEER) for figure in found["baselines"]]
    rows.sort(key=lambda row: row[0]["median"])
    limits = found["peaks"][0]["limits"]
    low = 0.6 * min(*limits.values(), rows[0][0]["median"])
    for place, (figure, _, color) in enumerate(rows):
        shares_of = map(_times, ratios(found, figure["median"]).values())
        _draw_row(axes, low, place, figure, color, "   ".join(shares_of))
    for (name, value), dash in zip(limits.items(), ("--", ":"), strict=True):
        label = f"{name}: {_number(value)} ns"
        axes.axvline(value, color=_LIMIT, linestyle=dash, linewidth=1.2, label=label, zorder=1.5)
    _name_rows(axes, low, rows)
    share = "" if not _peers(found) else r"; $\times$: of CasADi's closed form, of its plain C"
    axes.set_xlabel(f"ns per pose, median (thick: quartiles){share}")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2, ncols=2)


def _named(figure: Figures) -> str:
    """Return the name with the vectors of compiled C."""
    return f"{figure['name']} ({figure.get('vectors') or figure['what']})"


def _draw_row(axes: Axes, low: float, place: int, figure: Figures, color: str, share: str) -> None:
    first, third = figure["quartiles"]
    axes.plot([low, figure["median"]], [place, place], color=color, linewidth=1.0, alpha=0.5)
    axes.plot([first, third], [place, place], color=color, linewidth=3.0, solid_capstyle="butt")
    axes.plot(figure["median"], place, "o", color=color, markersize=7)
    axes.annotate(
        f"{_number(figure['median'])} ns   {share}",
        (max(figure["median"], third), place),
        (9, 0),
        textcoords="offset points",
        va="center",
        color=color,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
    )


def _name_rows(axes: Axes, low: float, rows: Sequence[tuple[Figures, str, str]]) -> None:
    """Set the labels of the rows, and a logarithmic axis with room for their numbers."""
    axes.set_yticks(range(len(rows)), [label for _, label, _ in rows])
    axes.set_xscale("log")
    high = max(max(figure["median"], figure["quartiles"][1]) for figure, _, _ in rows)
    axes.set_xlim(low, high * (high / low) ** 0.5)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.grid(visible=False, axis="y")
    axes.tick_params(axis="y", length=0)


def _times(ratio: float) -> str:
    """Format a ratio with three digits or more."""
    return rf"$\times${ratio:.{max(0, 2 - math.floor(math.log10(max(ratio, 1))))}f}"


def _draw_sizes(axes: Axes, found: Figures) -> None:
    names = dict.fromkeys(figure["name"] for figure in found["sweep"])
    for name, marker, color in zip(names, _MARKERS, _COLORS, strict=False):
        figures = [figure for figure in found["sweep"] if figure["name"] == name]
        sizes, medians = [figure["poses"] for figure in figures], [figure["median"] for figure in figures]
        ends = zip(medians, (figure["quartiles"] for figure in figures), strict=True)
        spread = [(median - low, high - median) for median, (low, high) in ends]
        label = f"ours: {name} (longest/shortest {found['flatness'][name]:.2f})"
        bars = list(zip(*spread, strict=True))
        look: Any = {"color": color, "marker": marker, "markersize": 5, "capsize": 2}
        axes.errorbar(sizes, medians, bars, label=label, **look)
    axes.set_xscale("log")
    axes.set_ylim(0, 1.35 * max((figure["quartiles"][1] for figure in found["sweep"]), default=1.0))
    axes.set(xlabel="poses in a batch", ylabel="ns per pose")
    axes.legend(loc="upper right", ncols=2)


def motion_picture(found: Figures) -> Canvas:
    """Plot the equations of motion and baselines of forward dynamics, with ratios to inverse dynamics."""
    motion = found["motion"]
    rows = [(figure, f"ours: {figure['name']}", _OURS) for figure in motion["ours"]]
    rows += [(figure, f"{figure['name']}: forward dynamics", _PEER) for figure in motion["baselines"]]
    rows.sort(key=lambda row: row[0]["median"])
    canvas = new_figure(8.6, 0.36 * len(rows) + 1.7)
    canvas.set_layout_engine("constrained", w_pad=0.12, h_pad=0.06)
    axes = canvas.subplots()
    canvas.suptitle(f"Equations of motion, one pose, ns: {found['machine']['processor']}", x=0.5)
    # A net time that is negative due to disturbances cannot be drawn on a logarithmic axis.
    low = 0.6 * min(figure["quartiles"][0] for figure, _, _ in rows if figure["quartiles"][0] > 0.0)
    for place, (figure, _, color) in enumerate(rows):
        limit = MOST.get(figure["name"])
        text = rf"   (target: $\times${limit[0]:g} at most)" if limit else ""
        _draw_row(axes, low, place, figure, color, _times(figure["ratio_to_inverse_dynamics"]) + text)
    _name_rows(axes, low, rows)
    axes.set_xlabel(r"ns per pose, median (thick: quartiles); $\times$: of our inverse dynamics")
    axes.set_title(_faster(motion), fontsize="medium")
    return canvas
