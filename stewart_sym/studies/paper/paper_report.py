"""Tables of ``reproduce`` as aligned plain text."""

import functools
import itertools
import textwrap
from collections.abc import Sequence
from typing import Any

from ...motion.straight_line import PAPER_PATHS
from ...reference.newton_euler import PAPER
from ...viewer.view import view
from ..common.report import Report
from ..common.text_tables import Figures, aligned
from .claims import NEAR_ZERO, PAPER_FLOPS, SERIAL_ARM_FLOPS, claims
from .plots import pictures
from .reproduce import Reproduction, run_columns

_FAULT_NAMES = {
    frozenset({1}): "1  no leg spin, (6), (8), (9)",
    frozenset({2}): "2  joint moment along s, (17)-(20)",
    frozenset({3}): "3  transport term twice, (16)",
    PAPER: "1+2+3  together: `paper`",
    frozenset({4}): "4  sign of sum K, (33); not in `paper`",
}
_PARTS = ("leg", "platform", "final", "total")


def full_report(found: Reproduction) -> Report:
    """Create the report: all tables, the runs over time, the plots of Figs. 4-10, and a view of each path."""
    verdicts = claims(found)
    head = [
        "Dasgupta & Mruthyunjaya (1998), section 5, recomputed",
        "",
        f"Robot: appendix of the paper, as printed. Computed by: {found.backend}.",
        "`paper`: equations as printed; `exact`: corrected equations. SI units.",
        "No rigid body can have the printed inertia tensors:",
        *(f"  {line}" for line in found.robot.find_invalid_inertias()),
    ]
    parts = [_claims_table(verdicts), _fault_table(found), _energy_table(found)]
    parts += [_operations_table(found)]
    data: dict[str, Any] = {
        "robot": found.robot.name,
        "computed_by": found.backend,
        "impossible_inertias": found.robot.find_invalid_inertias(),
        "claims": verdicts,
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
    tables = {f"path_{path}_{form}": run_columns(run) for (path, form), run in found.runs.items()}
    views = {f"Path {path}": functools.partial(view, found.robot, path) for path in PAPER_PATHS}
    return Report("\n\n\n".join(["\n".join(head), *parts]) + "\n", tables, data, pictures(found), views)


def _claims_table(verdicts: list[Figures]) -> str:
    rows = [("section", "claim", "`paper`", "`exact`", "verdict", "criterion")]
    for row in verdicts:
        paper, exact = row["paper"], row["exact"]
        verdict = paper["verdict"]
        if exact["verdict"] != verdict:
            verdict += f"; `exact` {exact['verdict']}"
        rows.append((row["where"], row["says"], paper["text"], exact["text"], verdict, row["rule"]))
    return _section(
        "(a) Claims of the paper, and computed results",
        _wrapped(rows, (8, 23, 22, 22, 8, 16)),
        "The verdict is for `paper`; a different verdict for `exact` follows after a semicolon. Dynamic "
        "fraction: |F_d / F| for all legs and all samples of the paper's time grid. Samples with |F| below "
        f"{NEAR_ZERO:.0%} of the leg's largest |F| on the path are excluded, because the fraction is "
        "unbounded at zero crossings of F. F_d = F - F_0 is the force due to the masses, weights, and "
        "friction of the legs. Condition number: ratio of the largest to the smallest singular value of H, "
        "with moments in N m.",
    )


def _fault_table(found: Reproduction) -> str:
    header = ["fault", *(f"Path {name}" for name in PAPER_PATHS)]
    header += [f"{name} at rest" for name in PAPER_PATHS]
    cells = []
    for cost in found.fault_costs:
        shares = [*cost["moving"].values(), *cost["at_rest"].values()]
        cells.append((_FAULT_NAMES[frozenset(cost["faults"])], *map(_percent, shares)))
    return _section(
        "(b) Force errors due to the faults of the printed equations",
        aligned(header, cells),
        "RMS of F - F_exact over all legs and samples, in percent of the RMS of F_exact, without friction. "
        "At rest: the same poses with zero rates and accelerations. Fault 4 is a misprint of (33); (35) is "
        "correct.",
    )


def _percent(share: float) -> str:
    return "0" if share == 0 else f"{100 * share:.2g}%" if share < 1e-3 else f"{100 * share:.2f}%"


def _energy_table(found: Reproduction) -> str:
    cells = []
    for row in found.work_energy:
        share = row["mismatch"]
        mismatch = f"{share:.0e}" if 0 < abs(share) < 1e-9 else f"{100 * share:+.4f}%" if share else "0"
        energies = (f"{row[name]:.6f}" for name in ("work_J", "gain_J"))
        cells.append((row["path"], f"`{row['formulation']}`", *energies, mismatch))
    return _section(
        "(c) Work of the actuators compared with the energy gain",
        aligned(("path", "equations", "work, J", "gain, J", "(work - gain) / gain"), cells, left=2),
        "Without friction. Work: integral of F.Ldot by Gauss-Legendre quadrature (24 points) between the "
        "jumps of acceleration. Gain: kinetic and potential energy of all 13 bodies in their true motion. "
        f"Path III passes a singular pose at {found.singular_time:.3f} s, where F is unbounded. The power "
        "F.Ldot = D.Ldot - c.twist is bounded, so the integral exists; the condition number amplifies its "
        "rounding error.",
    )


def _operations_table(found: Reproduction) -> str:
    rows = [("program of the paper", [PAPER_FLOPS[part] for part in _PARTS], "")]
    for row in sorted(found.operations, key=lambda row: row["formulation"] != "paper"):
        name = f"`{row['formulation']}` {'with' if row['friction'] else 'without'} friction"
        rows.append((name, [sum(row[part]) for part in _PARTS], "/".join(map(str, row["total"]))))
    header = ("kernel", "one leg", "platform", "final system", "total", "mul/add/div/sqrt", "x arm")
    cells = [
        (name, *map(str, sums), kinds, f"{sums[-1] / SERIAL_ARM_FLOPS:.2f}") for name, sums, kinds in rows
    ]
    return _section(
        "(d) Operations per time step",
        aligned(header, cells),
        "+, -, *, /, and sqrt count as one operation each. Negations, copies, and quantities prepared once "
        "per robot do not count. Total: six legs, platform, and final system (sum of c, solution of H x = c "
        f"with pivoting, F = D - x). x arm: ratio to the {SERIAL_ARM_FLOPS} operations of a serial arm with "
        "six joints (section 4.5). The paper counted MATLAB flops without friction.",
    )


def _section(title: str, table: str, notes: str) -> str:
    return "\n".join([title, "=" * len(title), "", table, "", textwrap.fill(notes, 110)])


def _wrapped(rows: Sequence[Sequence[str]], widths: Sequence[int]) -> str:
    """Format columns of given widths with wrapped cells and a blank line between the rows."""
    blocks = []
    for row in rows:
        cells = [textwrap.wrap(cell, width) for cell, width in zip(row, widths, strict=True)]
        lines = itertools.zip_longest(*cells, fillvalue="")
        blocks.append("\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines))
    rule = "-" * (sum(widths) + 2 * (len(widths) - 1))
    return "\n".join([blocks[0], rule, "\n\n".join(blocks[1:])])
