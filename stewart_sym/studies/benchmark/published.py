"""Tables of the documentation from ``bench.json``: shares, times, builds, passes, motion, compilation."""

from ...io.extras import install
from ..common.output import Figures, paragraph, table
from .figures import CLOSED, FORWARD, PLAIN

_RATIOS = ("ratio to CasADi, closed form", "ratio to CasADi, plain C")
"""Headers of the ratios to CasADi's two programs."""

README_ROWS = (
    "one pose",
    "batch, one core",
    "batch, columns",
    "batch, float",
    "every output",
    "NumPy kernel",
    CLOSED,
    PLAIN,
    "Pinocchio",
)


def tables(found: Figures) -> dict[str, str]:
    """Return Markdown tables by name; raise ValueError for a run without some of the compared software."""
    if found.get("left_out"):
        missing = ", ".join(found["left_out"])
        raise ValueError(
            f"bench.json: expected figures of all software that is compared, got none of {missing}: "
            f"{install('bench')} and run `stewart-sym benchmark` again"
        )
    return {
        "bench_shares": _shares(found),
        "bench_builds": _builds(found),
        "bench_times": _times(found) + _cores(found) + _sizes(found) + _calls(found),
        "bench_passes": _passes(found),
        "bench_motion": motion(found["motion"], found["rounds"]),
        "bench_compiling": _compiling(found),
        "readme_speed": _readme(found),
    }


def _readme(found: Figures) -> str:
    forces = {each["name"]: each["median"] for each in (*found["ours"], *found["baselines"])}
    named = {name: forces[name] for name in README_ROWS if name in forces}
    rows = [(name, f"{time:.0f}", f"{time / forces[CLOSED]:.2f}") for name, time in named.items()]
    ours = [each for each in found["motion"]["ours"] if each["name"] == FORWARD]
    rows += [(FORWARD, f"{each['median']:.0f}", "") for each in ours]
    baselines = found["motion"]["baselines"]
    rows += [(f"{FORWARD}, {each['name']}", f"{each['median']:.0f}", "") for each in baselines]
    return table(("forces with friction and load", "ns per pose", "relative to CasADi"), rows)


def _shares(found: Figures) -> str:
    made = found["shares"]
    kinds = [*dict.fromkeys(kind for each in made for kind in each["values"])]
    rows = [
        (
            each["name"] + (", us" if each["unit"] == "us" else ""),
            *(f"{each['values'][kind]:#.3g}" for kind in kinds),
            f"at least {each['at_least']}" if "at_least" in each else f"{each.get('at_most', '')}",
            f"{each.get('goal', '')}",
        )
        for each in made
    ]
    return table(("", *kinds, "at most", "goal"), rows)


def _builds(found: Figures) -> str:
    """Format times and cycles of all C code by instructions and flags, the clock, and the limits."""
    made = found["builds"]
    rows = [
        (
            each["name"],
            each["vectors"],
            " ".join(f"`{flag}`" for flag in each["flags"]),
            f"{each['median']:.0f}",
            f"{each['cycles']:.0f}",
            f"{each['ratio_to_closed_form']:.2f}",
            f"{each['ratio_to_casadi']:.2f}",
        )
        for each in made
    ]
    header = ("", "vectors", "flags", "ns per pose", "cycles", *_RATIOS)
    return table(header, rows) + _limits(found)


def _limits(found: Figures) -> str:
    operations = found["ours"][0]["operations"]
    each = "; ".join(
        f"{peak['instructions']} {operations:,} operations / {peak['numbers_in_a_vector']} numbers in a "
        "vector / "
        f"{peak['vectors_in_a_cycle']:.2f} vectors in a cycle = {next(iter(peak['limits'].values())):.1f} ns"
        for peak in found["peaks"]
    )
    return paragraph(
        f"The processor's clock is {found['cycle']['clock_GHz']:.2f} GHz, measured with a dependent chain of "
        "additions in the same rounds. The lower limit of the time assumes one operation per lane at the "
        "rate of fused multiply-adds in the same rounds, and counts divisions and square roots like other "
        f"operations. {each}."
    )


def _times(found: Figures) -> str:
    machine, compiler = found["machine"], found["software"]["compiler"]
    vectors = f" with {machine['vectors']}" if machine["vectors"] else ""
    every = (*found["ours"], *found["baselines"])
    closed = next(each["median"] for each in every if each["name"] == CLOSED)
    rows = [
        (
            each["name"],
            f"{each['median']:.0f}",
            f"{each['median'] / closed:.2f}",
            f"{each['ratio_to_casadi']:.2f}",
            each.get("vectors", ""),
        )
        for each in every
    ]
    return paragraph(
        f"The table lists nanoseconds per pose of `{found['formulation']}` with friction and load, medians "
        f"of {found['rounds']} rounds, as `stewart-sym benchmark` prints them. The machine has "
        f"{machine['cores']} cores of an {machine['processor']}{vectors}, and {compiler}. Ratios are to "
        "CasADi's C of the closed form in the leg frame, and to CasADi's C of the unchanged equations."
    ) + table(("", "ns per pose", *_RATIOS, "vectors"), rows)


def _cores(found: Figures) -> str:
    speedup = found["cores"]
    low, high = speedup["quartiles"]
    return paragraph(
        f"{speedup['cores']} cores over one core: {speedup['median']:.2f} times as fast (quartiles {low:.2f} "
        f"to {high:.2f} over the rounds) in a batch of {speedup['poses']:,} poses. Multiply-adds alone are "
        f"{found['cores_arithmetic']['median']:.2f} times as fast."
    )


def _sizes(found: Figures) -> str:
    (name, flatness), *_ = found["flatness"].items()
    swept = [each for each in found["sweep"] if each["name"] == name]
    counts = [f"{each['poses']:.0e}".replace("e+0", "e") for each in swept]
    return paragraph(
        f"From {counts[0]} to {counts[-1]} poses ({name}, one call of `forces` each) the longest "
        f"time per pose is {flatness:.2f} times the shortest."
    ) + table(("poses", *counts), [("ns per pose", *(f"{each['median']:.0f}" for each in swept))])


def _calls(found: Figures) -> str:
    rows = [
        (f"`{call}`", f"{each['median'] / 1e3:.2f}", f"{each['overhead_over_c_ns'] / 1e3:.2f}")
        for call, each in zip(("slot.solve()", "inverse_dynamics()"), found["calls"], strict=True)
    ]
    lead = paragraph("Calls for one pose from Python, and their time in addition to the C function:")
    return lead + table(("", "us per call", "us over C"), rows)


def _passes(found: Figures) -> str:
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
        "The table lists operations and times per pose after each reduction of the derivation, for the "
        f"forces alone. Batches have {batch:,} poses and use one core."
    ) + table(header, rows)


def motion(found: Figures, rounds: int) -> str:
    """Format times of the equations of motion and of their baselines."""
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
        "The table lists the functions of the closed form in C (`stewart_exact_motion.h`) for one pose at a "
        f"time. Nanoseconds per pose are medians of the same {rounds} rounds over {poses} poses."
    )
    about = paragraph(
        f"Forward dynamics is {found['times_faster']:.1f} times as fast as the better of the two baselines, "
        f"{better['name']} (target {found['target_times_faster']:g}). The baselines are {names}. Their model "
        "is a tree of all 13 bodies with five loop closures, the same load, and the same friction. They are "
        "called from Python with the state and the generalized forces; the time of a call for a model "
        "without bodies is subtracted."
    ) + paragraph(
        f"Their accelerations agree with ours to {agreement} of the largest one of a pose. MuJoCo's "
        "constraints are soft: the loops are open by "
        f" {1e9 * found['loops_open_m']:.0f} nm. No body can have the inertia tensors of the paper, and "
        "MuJoCo rejects them. Therefore this table uses physically possible tensors near them."
    )
    return lead + table(("", "ns per pose", "ratio to inverse dynamics", "at most"), rows) + about


def _compiling(found: Figures) -> str:
    seconds = " and ".join(f"`{each['source']}` in {each['median']:.2f} s" for each in found["compiling"])
    line = f"At the benchmark's flags the compiler builds {seconds}."
    size = found["text"]
    if size is not None:
        line += (
            " A program that prepares a robot and computes one pose at a time has "
            f"{size['total']:,} bytes of machine code ({found['machine']['architecture']}, "
            f"`{' '.join(size['flags'])}`, linked with `--gc-sections`)."
        )
    return paragraph(line)
