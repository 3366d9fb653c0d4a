"""What ``bench`` measured, as tables for the terminal and as a picture."""

import functools
import math
import textwrap
from collections.abc import Sequence
from typing import Any

from ...io.extras import install
from ..common.drawing import BLUE, RED, Axes, new_figure
from ..common.drawing import Figure as Canvas
from ..common.host import DISTURBED
from ..common.output import aligned
from ..common.report import SMALL, Picture, Report
from .figures import MOST, TIMES_FASTER, Benchmark, MotionFigures
from .samples import Figure, Samples
from .shares import Share, shares

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


def report(found: Benchmark) -> str:
    """All figures with units and how they were taken, as one text."""
    machine, software = found.machine, found.software
    sets = ", ".join(machine["instruction_sets"]) or "unknown instruction sets"
    head = [
        f"Inverse dynamics of {found.robot}, exact, one pose: F with friction, load and solve",
        "",
        f"{machine['processor']}, {machine['cores']} cores, {sets}; {software['compiler']}",
        *_others(machine["taken_by_others"]),
        " ".join(software["flags"]),
        ", ".join(f"{name} {software[key]}" for key, name in _SOFTWARE.items() if key in software),
    ]
    if found.left_out:
        missing = ", ".join(found.left_out)
        head.append(f"not installed and left out: {missing}; {install('bench')}")
    parts = ["\n".join(head), _shares(found), _candidates(found), _cores(found), _notes(found)]
    parts += [_builds(found), _calls(found), _sizes(found), _motion(found.motion)]
    if found.passes:
        parts.append(_passes(found))
    parts.append(_compiling(found))
    return "\n\n".join(parts) + "\n"


def _others(share: float | None) -> list[str]:
    """How far other processes disturbed the run; nothing where the system doesn't tell."""
    if share is None:
        return []
    verdict = ": the figures are disturbed, above all those of several cores" if share > DISTURBED else ""
    return [f"other processes took {100 * share:.0f} % of the cores' time{verdict}"]


def _shares(found: Benchmark) -> str:
    """The figures with targets, a column for each kind of instructions."""
    kinds = [peak.target for peak in found.peaks]
    rows = [
        (each.name, each.unit, *(_three_digits(each.values.get(kind)) for kind in kinds), *_targets(each))
        for each in shares(found.compiled)
    ]
    return aligned(("shares", "", *kinds, "at most", "goal"), rows, left=2)


def _three_digits(value: float | None) -> str:
    return "" if value is None else f"{value:#.3g}"


def _targets(share: Share) -> tuple[str, str]:
    """The bound, with words where it is the least, and the goal."""
    least = "at least " if share.least else ""
    return (
        "" if share.bound is None else f"{least}{share.bound:g}",
        "" if share.goal is None else f"{share.goal:g}",
    )


def _candidates(found: Benchmark) -> str:
    named = () if found.closed is None else ("x closed", "x CasADi")
    header = ("code", "poses", "ns", "cycles", "quartiles, ns", *named, "vectors")
    rows = [_row(found, figure, f"ours: {figure.name}") for figure in found.ours]
    rows += [_row(found, figure, figure.name) for figure in found.baselines]
    rows += [
        (name, "", *_times_of(found, value), "", *_ratios(found, value), found.peaks[0].target)
        for name, value in found.limits.items()
    ]
    return aligned(header, rows)


def _row(found: Benchmark, figure: Figure, name: str) -> tuple[str, ...]:
    loop = {"one pose": "1, C loop", "call": "1"}.get(figure.kind, str(figure.poses))
    time = figure.median
    ratios = _ratios(found, time)
    return name, loop, *_times_of(found, time), _spread(figure), *ratios, figure.vectors


def _times_of(found: Benchmark, time: float) -> tuple[str, str]:
    return _number(time), f"{found.cycles(time):.0f}"


def _ratios(found: Benchmark, time: float, target: str = "") -> tuple[str, ...]:
    """Shares of the times of CasADi's closed form and plain C; none where CasADi is left out."""
    return tuple(f"{ratio:.3f}" for ratio in found.ratios(time, target) if ratio is not None)


def _builds(found: Benchmark) -> str:
    """All C with its instructions and flags; ratios are to CasADi's C for the same instructions."""
    named = () if found.closed is None else ("x closed", "x CasADi")
    header = ("C by instructions and flags", "vectors", "operations", "ns", "cycles", *named)
    own = {peak.target: peak.flags for peak in found.peaks}
    rows = [
        (
            " ".join((each.name, *each.flags[len(own[each.target]) :])),
            each.vectors,
            _count(each),
            *_times_of(found, each.median),
            *_ratios(found, each.median, each.target),
        )
        for each in found.builds
    ]
    operations = found.compiled.operations
    for peak in found.peaks:
        for name, value in peak.limits(operations).items():
            ratios = _ratios(found, value, peak.target)
            rows.append((name, peak.target, str(operations), *_times_of(found, value), *ratios))
    without = [f"{target} with {' '.join(flags)}. " for target, flags in own.items() if flags]
    notes = (
        f"{''.join(without)}Flags come after those above. Vectors: the widest that the machine code computes "
        "with, where objdump tells."
    )
    if named:
        notes += " Ratios are to the faster of CasADi's builds for the same instructions."
    return f"{aligned(header, rows, left=2)}\n\n{_filled(notes)}"


def _cores(found: Benchmark) -> str:
    cores = found.cores
    low, high = cores.quartiles
    return (
        f"{cores.cores} cores over one core: {cores.median:.2f} times, quartiles {low:.2f} - {high:.2f}; "
        f"{cores.poses} poses, round by round;\nmultiply-adds alone, which is what the machine had to give: "
        f"{found.arithmetic.median:.2f} times"
    )


def _notes(found: Benchmark) -> str:
    worst = max(found.differences.values())
    return _filled(
        f"Medians and quartiles of {found.rounds} rounds; in each round every code takes its turn, for "
        f"{1e3 * found.shortest_sample:g} ms or more, after a run of its own that isn't timed. Ratios are of "
        f"medians. All found the same forces first, to {worst:.0e} of a pose's largest. "
        f"{_casadi_note(found)}{_called_note(found)}{_limit_note(found)}"
    )


def _casadi_note(found: Benchmark) -> str:
    if found.closed is None or found.plain is None:
        return ""
    return (
        "CasADi: the same equations written plainly, in vectors, or as the closed form in the leg frame, its "
        "cse() and its solve(), same compiler and flags, called from the same kind of C loop; it gives F "
        "alone and checks nothing. Each is compiled with products and sums fused by the compiler as well, "
        f"and the faster counts: {_flags(found.closed)} for the closed form, {_flags(found.plain)} for the "
        "plain one. "
    )


def _flags(figure: Figure) -> str:
    return " ".join(figure.flags) or "the common flags"


def _called_note(found: Benchmark) -> str:
    """What the figures of the baselines that Python calls are made of."""
    made = [
        f"{name} {' + '.join(f'{part.name} {_number(part.median)}' for part in parts[:-1])} - "
        f"{_number(parts[-1].median)}"
        for name, parts in found.parts.items()
    ]
    if not made:
        return ""
    gravity = ", gravity to Drake too" if "Drake" in found.parts else ""
    return (
        "Called from Python, less a call over nothing, ns: " + "; ".join(made) + ". Engines of rigid bodies "
        "compute over the tree of all 13 bodies, then LAPACK solves; joint angles, rates, accelerations, "
        f"friction, load and Jacobians are given to them{gravity}. "
    )


def _limit_note(found: Benchmark) -> str:
    peak = found.peaks[0]
    each = found.cycle.median / (peak.multiply_add.median * peak.lanes)
    return (
        f"Cycles: of a clock of {1 / found.cycle.median:.2f} GHz, one for each addition of a dependent chain "
        f"timed in the same rounds. Limit: {_count(found.ours[0])} operations / {peak.lanes} numbers in a "
        f"vector / {each:.2f} vectors in a cycle, the rate of fused multiply-adds in the same rounds; "
        "divisions and roots count as any other; each operation fills the place of one multiply-add, or "
        "two of them one."
    )


def _calls(found: Benchmark) -> str:
    header = ("one pose from Python", "us per call", "quartiles", "us over C")
    rows = [
        (
            figure.name,
            f"{figure.median / 1e3:.2f}",
            " - ".join(f"{value / 1e3:.2f}" for value in figure.quartiles),
            f"{found.overhead(figure) / 1e3:.2f}",
        )
        for figure in found.calls
    ]
    return aligned(header, rows)


def _sizes(found: Benchmark) -> str:
    sizes = sorted({figure.poses for figure in found.sweep})
    names = dict.fromkeys(figure.name for figure in found.sweep)
    medians = {(figure.name, figure.poses): _number(figure.median) for figure in found.sweep}
    counts = (f"{size:.0e}".replace("e+0", "e") for size in sizes)
    header = ("ns per pose, batch of", *counts, "longest/shortest")
    rows = [
        (f"ours: {name}", *(medians.get((name, size), "") for size in sizes), f"{found.flatness(name):.2f}")
        for name in names
    ]
    rounds = {figure.poses: len(figure.raw) for figure in found.sweep}
    rows.append(("rounds", *(str(rounds[size]) for size in sizes), ""))
    return aligned(header, rows)


def _motion(found: MotionFigures) -> str:
    header = ("equations of motion, one pose in a C loop", "ns per pose", "quartiles", "x inverse", "target")
    rows = [(f"ours: {each.name}", *_motion_cells(found, each), _target(each.name)) for each in found.ours]
    rows += [(f"{each.name}, {each.what}", *_motion_cells(found, each), "") for each in found.baselines]
    return "\n\n".join(filter(None, [aligned(header, rows), _faster(found), _motion_notes(found)]))


def _motion_cells(found: MotionFigures, figure: Figure) -> tuple[str, str, str]:
    return _number(figure.median), _spread(figure), f"{found.ratio(figure):.2f}"


def _target(name: str) -> str:
    return ", goal ".join(f"{limit:g}" for limit in MOST.get(name, ()))


def _faster(found: MotionFigures) -> str:
    """Forward dynamics beside the faster baseline; empty without any."""
    if found.better is None:
        return ""
    which = f"the better of the two, {found.better.name}" if len(found.baselines) > 1 else found.better.name
    return f"forward dynamics: {found.times_faster:.1f} x faster than {which} (target {TIMES_FASTER:g})"


def _motion_notes(found: MotionFigures) -> str:
    ours = max(found.differences[each.name] for each in found.ours)
    return _filled(
        f"{found.robot} with inertia tensors that bodies can have, for everybody here; same "
        f"rounds and turns, {found.ours[0].poses} poses. All were compared with the vector reference and its "
        f"differences first, ours to {ours:.0e} of a pose's largest number."
        f"{_baselines_note(found)}{_opened_note(found)}"
    )


def _baselines_note(found: MotionFigures) -> str:
    if not found.baselines:
        return ""
    taken = ", ".join(
        f"{call.name} {_number(call.median)} less {_number(empty.median)} ns"
        for call, empty in zip(found.calls, found.empty, strict=True)
    )
    baselines = ", ".join(f"{each.name} {found.differences[each.name]:.0e}" for each in found.baselines)
    return (
        " Baselines: forward dynamics over a tree of all 13 bodies, five points closed by constraints, same "
        "friction, load and gravity; called from Python, less a call over a model without bodies "
        f"({taken}); joint coordinates, rates and generalised forces are given to them. Their accelerations "
        f"agree with the motion's to {baselines} of a pose's largest."
    )


def _opened_note(found: MotionFigures) -> str:
    if found.opened is None:
        return ""
    return (
        " MuJoCo's constraints are the stiffest it has and still give way: their springs make up for it, "
        f"with the loops open by {1e9 * found.opened:.0f} nm."
    )


def _passes(found: Benchmark) -> str:
    batch = f"batch of {found.passes[0].batch.poses}"
    counts = ("operations", "with friction")
    header = ("after the pass", *counts, "one pose, ns", "quartiles", batch, "quartiles")
    rows = [
        (
            each.name,
            *map(str, each.operations),
            _number(each.one_pose.median),
            _spread(each.one_pose),
            _number(each.batch.median),
            _spread(each.batch),
        )
        for each in found.passes
    ]
    meanings = "\n".join(f"{each.name}: {each.meaning}" for each in found.passes)
    return f"{aligned(header, rows)}\n\n{meanings}"


def _compiling(found: Benchmark) -> str:
    header = ("compiling and size", "", "quartiles", "")
    flags = " ".join(found.software["flags"])
    rows = [
        (
            each.source,
            f"{each.median:.2f} s",
            " - ".join(f"{value:.2f}" for value in each.quartiles),
            f"median of {len(each.raw)}",
        )
        for each in found.compiling
    ]
    notes = f"Compiled past the cache with {flags}."
    if found.text is not None:
        parts = ", ".join(f"{name} {size}" for name, size in found.text.functions.items())
        rows.append(("text for one pose", f"{found.text.total} bytes", "", ""))
        notes += (
            f" Text: functions of {found.text.source} that a program which prepares a robot and computes one "
            f"pose is left with ({parts}), {' '.join(found.text.flags)}, linked with --gc-sections."
        )
    return f"{aligned(header, rows)}\n\n{_filled(notes)}"


def _filled(notes: str) -> str:
    return textwrap.fill(notes, WIDTH, break_on_hyphens=False)


def _count(figure: Figure) -> str:
    return "" if figure.operations is None else str(figure.operations)


def _spread(figure: Samples) -> str:
    return " - ".join(map(_number, figure.quartiles))


def _number(value: float) -> str:
    return f"{value:.1f}" if value < 1000 else f"{value:.0f}"


# --- the picture ------------------------------------------------------------------------------


def full_report(found: Benchmark) -> Report:
    """All figures as tables, for programs, and as pictures."""
    drawn = {"bench": picture, "bench_motion": motion_picture}
    figures = {
        name: Picture(functools.partial(draw, found), SMALL, ("png", "svg")) for name, draw in drawn.items()
    }
    return Report(report(found), data=found.as_json(), figures=figures)


def picture(found: Benchmark) -> Canvas:
    """Every candidate's time on a log axis, with the ratio to CasADi; below, time over batch size."""
    rows = len(found.ours) + len(found.baselines)
    heights = [0.36 * rows + 1.0, 2.3]
    canvas = new_figure(8.6, sum(heights) + 0.7)
    canvas.set_layout_engine("constrained", w_pad=0.12, h_pad=0.06)
    above, below = canvas.subplots(2, 1, height_ratios=heights)
    processor = found.machine["processor"]
    canvas.suptitle(f"Inverse dynamics of a Stewart platform, ns per pose: {processor}", x=0.5)
    _draw_candidates(above, found)
    _draw_sizes(below, found)
    return canvas


def _draw_candidates(axes: Axes, found: Benchmark) -> None:
    rows = [(figure, f"ours: {_named(figure)}", _OURS) for figure in found.ours]
    rows += [(figure, _named(figure), _PEER) for figure in found.baselines]
    rows.sort(key=lambda row: row[0].median)
    limits = found.limits
    low = 0.6 * min(*limits.values(), rows[0][0].median)
    for place, (figure, _, color) in enumerate(rows):
        shares_of = (_times(ratio) for ratio in found.ratios(figure.median) if ratio is not None)
        _draw_row(axes, low, place, figure, color, "   ".join(shares_of))
    for (name, value), dash in zip(limits.items(), ("--", ":"), strict=True):
        label = f"{name}: {_number(value)} ns"
        axes.axvline(value, color=_LIMIT, linestyle=dash, linewidth=1.2, label=label, zorder=1.5)
    _name_rows(axes, low, rows)
    share = "" if found.closed is None else r"; $\times$: of CasADi's closed form, of its plain C"
    axes.set_xlabel(f"ns per pose, median (thick: quartiles){share}")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.2, ncols=2)


def _named(figure: Figure) -> str:
    """The name, with the vectors of compiled C."""
    return f"{figure.name} ({figure.vectors or figure.what})"


def _draw_row(axes: Axes, low: float, place: int, figure: Figure, color: str, share: str) -> None:
    first, third = figure.quartiles
    axes.plot([low, figure.median], [place, place], color=color, linewidth=1.0, alpha=0.5)
    axes.plot([first, third], [place, place], color=color, linewidth=3.0, solid_capstyle="butt")
    axes.plot(figure.median, place, "o", color=color, markersize=7)
    axes.annotate(
        f"{_number(figure.median)} ns   {share}",
        (max(figure.median, third), place),
        (9, 0),
        textcoords="offset points",
        va="center",
        color=color,
        bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
    )


def _left_end(rows: Sequence[tuple[Figure, str, str]]) -> float:
    """Where the axis begins: a net time that other work made negative has no place on a log axis."""
    return 0.6 * min(figure.quartiles[0] for figure, _, _ in rows if figure.quartiles[0] > 0.0)


def _name_rows(axes: Axes, low: float, rows: Sequence[tuple[Figure, str, str]]) -> None:
    """Labels of the rows, and a log axis with room for their numbers."""
    axes.set_yticks(range(len(rows)), [label for _, label, _ in rows])
    axes.set_xscale("log")
    high = max(max(figure.median, figure.quartiles[1]) for figure, _, _ in rows)
    axes.set_xlim(low, high * (high / low) ** 0.5)
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.grid(visible=False, axis="y")
    axes.tick_params(axis="y", length=0)


def _times(ratio: float) -> str:
    """Three digits or more."""
    return rf"$\times${ratio:.{max(0, 2 - math.floor(math.log10(max(ratio, 1))))}f}"


def _draw_sizes(axes: Axes, found: Benchmark) -> None:
    names = dict.fromkeys(figure.name for figure in found.sweep)
    for name, marker, color in zip(names, _MARKERS, _COLORS, strict=False):
        figures = [figure for figure in found.sweep if figure.name == name]
        sizes, medians = [figure.poses for figure in figures], [figure.median for figure in figures]
        ends = zip(medians, (figure.quartiles for figure in figures), strict=True)
        spread = [(median - low, high - median) for median, (low, high) in ends]
        label = f"ours: {name} (longest/shortest {found.flatness(name):.2f})"
        bars = list(zip(*spread, strict=True))
        look: Any = {"color": color, "marker": marker, "markersize": 5, "capsize": 2}
        axes.errorbar(sizes, medians, bars, label=label, **look)
    axes.set_xscale("log")
    axes.set_ylim(0, 1.35 * max((figure.quartiles[1] for figure in found.sweep), default=1.0))
    axes.set(xlabel="poses in a batch", ylabel="ns per pose")
    axes.legend(loc="upper right", ncols=2)


def motion_picture(found: Benchmark) -> Canvas:
    """Equations of motion and the baselines of forward dynamics, with the ratio to our inverse dynamics."""
    motion = found.motion
    rows = [(figure, f"ours: {figure.name}", _OURS) for figure in motion.ours]
    rows += [(figure, f"{figure.name}: forward dynamics", _PEER) for figure in motion.baselines]
    rows.sort(key=lambda row: row[0].median)
    canvas = new_figure(8.6, 0.36 * len(rows) + 1.7)
    canvas.set_layout_engine("constrained", w_pad=0.12, h_pad=0.06)
    axes = canvas.subplots()
    canvas.suptitle(f"Equations of motion, one pose, ns: {found.machine['processor']}", x=0.5)
    low = _left_end(rows)
    for place, (figure, _, color) in enumerate(rows):
        limit = MOST.get(figure.name)
        text = rf"   (target: $\times${limit[0]:g} at most)" if limit else ""
        _draw_row(axes, low, place, figure, color, _times(motion.ratio(figure)) + text)
    _name_rows(axes, low, rows)
    axes.set_xlabel(r"ns per pose, median (thick: quartiles); $\times$: of our inverse dynamics")
    axes.set_title(_faster(motion), fontsize="medium")
    return canvas
