"""Tables of ``reproduce`` as aligned plain text."""

import functools
import itertools
import textwrap
from collections.abc import Sequence
from typing import Any

import numpy as np

from ...motion.straight_line import PAPER_PATHS
from ...reference.newton_euler import EXACT, PAPER
from ...viewer.view import view
from ..common.output import Figures, aligned
from ..common.report import Report
from .claims import NEAR_ZERO, PAPER_FLOPS, SERIAL_ARM_FLOPS, claims, counted_fractions
from .plots import pictures
from .reproduce import Reproduction, run_columns

WIDTH = 110

_FAULT_NAMES = {
    frozenset({1}): "1  no leg spin, (6), (8), (9)",
    frozenset({2}): "2  joint moment along s, (17)-(20)",
    frozenset({3}): "3  transport term twice, (16)",
    PAPER: "1+2+3  together: `paper`",
    frozenset({4}): "4  sign of sum K, (33); not in `paper`",
    EXACT: "none: `exact`",
}


def full_report(found: Reproduction) -> Report:
    """Create the report: all tables, the runs over time, the plots of Figs. 4-10, and a view of each path."""
    tables = {f"path_{path}_{form}": run_columns(run) for (path, form), run in found.runs.items()}
    views = {f"Path {path}": functools.partial(view, found.robot, path) for path in PAPER_PATHS}
    return Report(report(found), tables, _data(found), pictures(found), views)


def _data(found: Reproduction) -> dict[str, Any]:
    return {
        "robot": found.robot.name,
        "computed_by": found.backend,
        "impossible_inertias": found.robot.find_invalid_inertias(),
        "claims": claims(found),
        "fault_costs": found.fault_costs,
        "work_and_energy": found.work_energy,
        "operations": found.operations,
        "singular_time_path_III_s": found.singular_time,
        "units": {
            "fault_costs": "RMS of F - F_exact over RMS of F_exact",
            "mismatch": "fraction of the gain",
            "operations": "multiplications, additions, divisions, square roots",
        },
    }


def report(found: Reproduction) -> str:
    """Format all tables, with units and definitions, as one text."""
    head = [
        "Dasgupta & Mruthyunjaya (1998), section 5, recomputed",
        "",
        f"Robot: appendix of the paper, as printed. Computed by: {found.backend}.",
        "`paper`: equations as printed; `exact`: corrected equations. SI units.",
        "No rigid body can have the printed inertia tensors:",
        *(f"  {line}" for line in found.robot.find_invalid_inertias()),
    ]
    tables = (_claims_table, _fault_table, _energy_table, _operations_table)
    return "\n\n\n".join(["\n".join(head), *(table(found) for table in tables)]) + "\n"


def _claims_table(found: Reproduction) -> str:
    still = float(np.median(counted_fractions(found.rest["exact"])))
    cells = [
        (row["where"], row["says"], row["paper"]["text"], row["exact"]["text"], _verdict(row), row["rule"])
        for row in claims(found)
    ]
    header = ("section", "claim", "`paper`", "`exact`", "verdict", "criterion")
    return _section(
        "(a) Claims of the paper, and computed results",
        _wrapped(header, cells, (8, 23, 22, 22, 8, 16)),
        "The verdict is for `paper`; a different verdict for `exact` follows after a semicolon. Dynamic "
        "fraction: |F_d / F| for all legs and all samples of the paper's time grid. Samples with |F| below "
        f"{NEAR_ZERO:.0%} of the leg's largest |F| on the path are excluded, because the fraction is "
        "unbounded at zero crossings of F. F_d = F - F_0 is the force due to the masses, weights, and "
        "friction of the legs. Most of it is weight: with the platform at rest on Path I, the median of the "
        f"fraction is {still:.1%} (`exact`). Condition number: ratio of the largest to the smallest singular "
        "value of H, with moments in N m.",
    )


def _verdict(row: Figures) -> str:
    paper, exact = (row[form]["verdict"] for form in ("paper", "exact"))
    return str(paper) if paper == exact else f"{paper}; `exact` {exact}"


def _fault_table(found: Reproduction) -> str:
    header = ["fault", *(f"Path {name}" for name in PAPER_PATHS)]
    header += [f"{name} at rest" for name in PAPER_PATHS]
    cells = [
        (
            _FAULT_NAMES[frozenset(cost["faults"])],
            *(_percent(cost[how][name]) for how in ("moving", "at_rest") for name in PAPER_PATHS),
        )
        for cost in found.fault_costs
    ]
    return _section(
        "(b) Force errors due to the faults of the printed equations",
        aligned(header, cells),
        "RMS of F - F_exact over all legs and samples, in percent of the RMS of F_exact, without friction. "
        "At rest: the same poses with zero rates and accelerations. Fault 4 is a misprint of (33); (35) is "
        "correct.",
    )


def _energy_table(found: Reproduction) -> str:
    header = ("path", "faults", "work, J", "gain, J", "(work - gain) / gain")
    cells = []
    for row in found.work_energy:
        work, gain = (f"{row[name]:.6f}" for name in ("work_J", "gain_J"))
        kept = _FAULT_NAMES[frozenset(row["faults"])]
        cells.append((row["path"], kept, work, gain, _mismatch(row["mismatch"])))
    return _section(
        "(c) Work of the actuators compared with the energy gain",
        aligned(header, cells, left=2),
        "Without friction. Work: integral of F.Ldot by Gauss-Legendre quadrature (24 points) between the "
        "jumps of acceleration. The kernels compute F for none and for all of the faults 1 to 3, the "
        "reference computes it otherwise. Gain: kinetic and potential energy of all 13 bodies in their true "
        f"motion. Path III passes a singular pose at {found.singular_time:.3f} s, where F is unbounded. The "
        "power F.Ldot = D.Ldot - c.twist is bounded, so the integral exists; the condition number amplifies "
        "its rounding error.",
    )


def _operations_table(found: Reproduction) -> str:
    header = ("kernel", "one leg", "platform", "final system", "total", "mul/add/div/sqrt", "x arm")
    paper = (str(PAPER_FLOPS[part]) for part in ("leg", "platform", "final", "total"))
    cells = [("program of the paper", *paper, "", _arms(PAPER_FLOPS["total"]))]
    operations = sorted(found.operations, key=lambda row: row["formulation"] != "paper")
    for row in operations:
        sums = (str(sum(row[part])) for part in ("leg", "platform", "final", "total"))
        cells.append((_kernel_name(row), *sums, _counts(row["total"]), _arms(sum(row["total"]))))
    header_apart = ("mul/add/div/sqrt", "one leg", "platform", "final system")
    apart = [
        (_kernel_name(row), *(_counts(row[part]) for part in ("leg", "platform", "final")))
        for row in operations
    ]
    return _section(
        "(d) Operations per time step",
        aligned(header, cells) + "\n\n" + aligned(header_apart, apart),
        "+, -, *, /, and sqrt count as one operation each. Negations, copies, and quantities prepared once "
        "per robot do not count. Total: six legs, platform, and final system (sum of c, solution of H x = c "
        f"with pivoting, F = D - x). x arm: ratio to the {SERIAL_ARM_FLOPS} operations of a serial arm with "
        "six joints (section 4.5). The paper counted MATLAB flops without friction.",
    )


def _kernel_name(row: Figures) -> str:
    return f"`{row['formulation']}` {'with' if row['friction'] else 'without'} friction"


def _counts(part: Sequence[int]) -> str:
    return "/".join(map(str, part))


def _arms(total: int) -> str:
    return f"{total / SERIAL_ARM_FLOPS:.2f}"


def _percent(share: float) -> str:
    return "0" if share == 0 else f"{100 * share:.2g}%" if share < 1e-3 else f"{100 * share:.2f}%"


def _mismatch(share: float) -> str:
    return f"{share:.0e}" if 0 < abs(share) < 1e-9 else "0" if share == 0 else f"{100 * share:+.4f}%"


def _section(title: str, table: str, notes: str) -> str:
    return "\n".join([title, "=" * len(title), "", table, "", textwrap.fill(notes, WIDTH)])


def _wrapped(header: Sequence[str], rows: Sequence[Sequence[str]], widths: Sequence[int]) -> str:
    """Format columns of given widths with wrapped cells and a blank line between the rows."""
    blocks = [_block(row, widths) for row in (header, *rows)]
    rule = "-" * (sum(widths) + 2 * (len(widths) - 1))
    return "\n".join([blocks[0], rule, "\n\n".join(blocks[1:])])


def _block(row: Sequence[str], widths: Sequence[int]) -> str:
    cells = [textwrap.wrap(cell, width) for cell, width in zip(row, widths, strict=True)]
    lines = itertools.zip_longest(*cells, fillvalue="")
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines)
