"""What ``bench`` measured: figures with all their samples, and the ratios that are made of them."""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from .baselines import CASADI, NAME

FORWARD, DERIVATIVES = "forward dynamics", "derivatives"

MOST = {FORWARD: (2.0,), DERIVATIVES: (8.0, 5.0)}
"""Targets: the most that a function may take, in times of inverse dynamics; and the goal beyond."""

TIMES_FASTER = 20.0
"""Target: how many times as fast as the better baseline forward dynamics is to be."""


class Samples:
    """Medians and quartiles of ``raw``."""

    raw: tuple[float, ...]

    @property
    def median(self) -> float:
        """Median of the samples."""
        return float(np.median(self.raw))

    @property
    def quartiles(self) -> tuple[float, float]:
        """First and third quartile of the samples."""
        low, high = np.percentile(self.raw, (25, 75))
        return float(low), float(high)

    def as_json(self) -> dict[str, Any]:
        """Every field, the median and the quartiles, ready for ``json``."""
        assert dataclasses.is_dataclass(self)
        fields = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        return {**fields, "median": self.median, "quartiles": self.quartiles}


@dataclass(frozen=True)
class Figure(Samples):
    """Nanoseconds a pose, one sample of each round in ``raw``; ``operations`` of a pose where counted."""

    name: str
    what: str
    kind: str
    poses: int
    raw: tuple[float, ...]
    operations: int | None = None


@dataclass(frozen=True)
class Speedup(Samples):
    """How many times as fast ``cores`` cores are as one over ``poses`` poses, round by round.

    poses: 0 for arithmetic that needs no memory, which shows what the machine had to give.
    """

    cores: int
    poses: int
    raw: tuple[float, ...]


@dataclass(frozen=True)
class CompileTime(Samples):
    """Seconds to compile one kernel's source into a library, one compilation each in ``raw``."""

    source: str
    raw: tuple[float, ...]


@dataclass(frozen=True)
class TextSize:
    """Bytes of machine code of each function that a program of one-pose calls is left with."""

    source: str
    flags: tuple[str, ...]
    functions: Mapping[str, int]

    @property
    def total(self) -> int:
        """Bytes of all of them."""
        return sum(self.functions.values())

    def as_json(self) -> dict[str, Any]:
        """Every field and the sum, ready for ``json``."""
        fields = {"source": self.source, "flags": self.flags, "functions": dict(self.functions)}
        return {**fields, "unit": "bytes", "total": self.total}


@dataclass(frozen=True)
class PassFigures:
    """The kernel after one pass: ``operations`` of a pose without and with friction, and its times."""

    name: str
    meaning: str
    operations: tuple[int, int]
    one_pose: Figure
    batch: Figure

    def as_json(self) -> dict[str, Any]:
        """Everything, ready for ``json``."""
        return {
            "name": self.name,
            "meaning": self.meaning,
            "operations": dict(zip(("without_friction", "with_friction"), self.operations, strict=True)),
            "one_pose": self.one_pose.as_json(),
            "batch": self.batch.as_json(),
        }


@dataclass(frozen=True)
class MotionFigures:
    """Equations of motion, one pose: our functions, the first of which ratios refer to, and the baselines.

    baselines: those installed. calls, empty: what each baseline's figure is the difference of, a call from
    Python and one over nothing. opened: m, how far MuJoCo's loops are open, None without it. differences: by
    program, from the reference's numbers, share of a pose's largest.
    """

    robot: str
    ours: tuple[Figure, ...]
    baselines: tuple[Figure, ...]
    calls: tuple[Figure, ...]
    empty: tuple[Figure, ...]
    opened: float | None
    differences: Mapping[str, float]

    @property
    def forward(self) -> Figure:
        """Our forward dynamics."""
        return next(figure for figure in self.ours if figure.name == FORWARD)

    @property
    def better(self) -> Figure | None:
        """The faster of the baselines; None without any."""
        return min(self.baselines, key=lambda figure: figure.median, default=None)

    @property
    def times_faster(self) -> float | None:
        """Time of the faster baseline over ours, forward dynamics; None without a baseline."""
        return None if self.better is None else self.better.median / self.forward.median

    def ratio(self, figure: Figure) -> float:
        """Median over that of our inverse dynamics."""
        return figure.median / self.ours[0].median

    def as_json(self) -> dict[str, Any]:
        """Everything measured, with ratios and targets, ready for ``json``."""
        return {
            "unit": "ns/pose",
            "robot": self.robot,
            "inertia_tensors": "near the given ones, such as bodies can have",
            "ratio_to": self.ours[0].name,
            "ours": [self._entry(figure) for figure in self.ours],
            "baselines": [
                {**self._entry(figure), "ratio_to_forward_dynamics": figure.median / self.forward.median}
                for figure in self.baselines
            ],
            "calls": [figure.as_json() for figure in self.calls],
            "empty_calls": [figure.as_json() for figure in self.empty],
            **_measured(
                better_baseline=None if self.better is None else self.better.name,
                times_faster=self.times_faster,
            ),
            "target_times_faster": TIMES_FASTER,
            **_measured(loops_open_m=self.opened),
            "largest_difference": dict(self.differences),
        }

    def _entry(self, figure: Figure) -> dict[str, Any]:
        targets = dict(zip(("target", "goal"), MOST.get(figure.name, ()), strict=False))
        return {**figure.as_json(), "ratio_to_inverse_dynamics": self.ratio(figure), **targets}


def _measured(**entries: Any) -> dict[str, Any]:
    """The entries but for those that are None, since what they are made of is left out."""
    return {name: entry for name, entry in entries.items() if entry is not None}


@dataclass(frozen=True)
class Benchmark:
    """Everything that ``bench`` measured.

    shortest_sample: seconds that a sample lasted at least. ours, baselines: time per pose. cores, arithmetic:
    all cores over one. calls: time of a Python call for one pose. parts: what Pinocchio's figure is made
    of. sweep: batches of all sizes. motion: the second group. passes: the kernel after each reduction.
    compiling: time of the compiler. text: None where the system's linker or ``nm`` can't tell.
    multiply_add: ns for one fused multiply-add of one number, on one core; lanes: numbers in one
    instruction. differences: by candidate, from the reference's forces, share of a pose's largest.
    machine, software, clock: as JSON takes them. left_out: software that is not installed and not compared;
    ours, baselines and all that follows from them are without it.
    """

    robot: str
    rounds: int
    shortest_sample: float
    ours: tuple[Figure, ...]
    baselines: tuple[Figure, ...]
    cores: Speedup
    arithmetic: Speedup
    calls: tuple[Figure, ...]
    parts: tuple[Figure, ...]
    sweep: tuple[Figure, ...]
    motion: MotionFigures
    passes: tuple[PassFigures, ...]
    compiling: tuple[CompileTime, ...]
    text: TextSize | None
    multiply_add: Figure
    lanes: int
    differences: Mapping[str, float]
    machine: Mapping[str, Any]
    software: Mapping[str, Any]
    clock: Mapping[str, Any]
    left_out: tuple[str, ...] = ()

    @property
    def casadi(self) -> Figure | None:
        """What ratios refer to; None where CasADi is left out."""
        return next((figure for figure in self.baselines if figure.name == CASADI.name), None)

    @property
    def limits(self) -> Mapping[str, float]:
        """Least ns per pose for the operations of the first of ``OURS`` on one core, by what fills a lane."""
        operations = self.ours[0].operations or 0
        each = operations * self.multiply_add.median
        return {"limit, an operation a lane": each, "limit, all fused in pairs": each / 2}

    def ratio(self, time: float) -> float | None:
        """A time, ns, over CasADi's median; None without CasADi."""
        return None if self.casadi is None else time / self.casadi.median

    def overhead(self, call: Figure) -> float:
        """Ns that a Python call takes over the same pose in C."""
        return call.median - self.ours[0].median

    def flatness(self, name: str) -> float:
        """Longest time per pose over all batch sizes, divided by the shortest."""
        medians = [figure.median for figure in self.sweep if figure.name == name]
        return max(medians) / min(medians)

    def as_json(self) -> dict[str, Any]:
        """Return every figure with its unit, raw and condensed, ready for ``json``."""
        return {
            "schema": 3,
            "unit": "ns/pose",
            "robot": self.robot,
            "formulation": NAME,
            "rounds": self.rounds,
            "shortest_sample_s": self.shortest_sample,
            "machine": dict(self.machine),
            "software": dict(self.software),
            "clock": dict(self.clock),
            "left_out": list(self.left_out),
            **_measured(ratio_to=None if self.casadi is None else CASADI.name),
            "ours": [self._entry(figure) for figure in self.ours],
            "baselines": [self._entry(figure) for figure in self.baselines],
            "cores": {**self.cores.as_json(), "unit": "times as fast as one core"},
            "cores_arithmetic": {**self.arithmetic.as_json(), "unit": "times as fast as one core"},
            "pinocchio_parts": [figure.as_json() for figure in self.parts],
            "calls": [
                {**figure.as_json(), "overhead_over_c_ns": self.overhead(figure)} for figure in self.calls
            ],
            "sweep": [figure.as_json() for figure in self.sweep],
            "flatness": {name: self.flatness(name) for name in dict.fromkeys(f.name for f in self.sweep)},
            "motion": self.motion.as_json(),
            "passes": [each.as_json() for each in self.passes],
            "compiling": [{**each.as_json(), "unit": "s"} for each in self.compiling],
            "text": None if self.text is None else self.text.as_json(),
            "multiply_add": {
                **self.multiply_add.as_json(),
                "unit": "ns per fused multiply-add of one number, one core",
                "rate_per_s": 1e9 / self.multiply_add.median,
                "numbers_in_a_vector": self.lanes,
            },
            "limits": dict(self.limits),
            "largest_difference": dict(self.differences),
        }

    def _entry(self, figure: Figure) -> dict[str, Any]:
        return {**figure.as_json(), **_measured(ratio_to_casadi=self.ratio(figure.median))}
