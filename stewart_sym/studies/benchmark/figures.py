"""What ``bench`` measured, and the ratios that are made of it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .samples import CLOSED, DERIVATIVES, FORWARD, NAME, PLAIN, CompileTime, Figure, Peak, Speedup, TextSize
from .shares import Measured, shares

MOST = {FORWARD: (2.0,), DERIVATIVES: (8.0, 5.0)}
"""Targets: the most that a function may take, in times of inverse dynamics; and the goal beyond."""

TIMES_FASTER = 20.0
"""Target: how many times as fast as the better baseline forward dynamics is to be."""


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

    shortest_sample: seconds that a sample lasted at least. ours, baselines: time per pose; of a baseline
    built in several ways the fastest. builds: all C, for all instructions and with all flags. cores,
    arithmetic: all cores over one. calls: time of a Python call for one pose. parts: what the figures of
    baselines that Python calls are made of, the last subtracted. sweep: batches of all sizes. motion: the
    second group. passes: the kernel after each reduction. compiling: time of the compiler. text: None where
    the system's linker or ``nm`` can't tell. cycle: ns of one addition in a chain, a cycle of the clock.
    peaks: of each target, all of the processor's instructions first. differences: by candidate, from the
    reference's forces, share of a pose's largest. machine, software, clock: as JSON takes them. left_out:
    software that is not installed and not compared; ours, baselines and all that follows from them are
    without it.
    """

    robot: str
    rounds: int
    shortest_sample: float
    ours: tuple[Figure, ...]
    baselines: tuple[Figure, ...]
    builds: tuple[Figure, ...]
    cores: Speedup
    arithmetic: Speedup
    calls: tuple[Figure, ...]
    parts: Mapping[str, tuple[Figure, ...]]
    sweep: tuple[Figure, ...]
    motion: MotionFigures
    passes: tuple[PassFigures, ...]
    compiling: tuple[CompileTime, ...]
    text: TextSize | None
    cycle: Figure
    peaks: tuple[Peak, ...]
    differences: Mapping[str, float]
    machine: Mapping[str, Any]
    software: Mapping[str, Any]
    clock: Mapping[str, Any]
    left_out: tuple[str, ...] = ()

    @property
    def plain(self) -> Figure | None:
        """CasADi's C of the equations as stated; None where CasADi is left out."""
        return next((figure for figure in self.baselines if figure.name == PLAIN), None)

    @property
    def closed(self) -> Figure | None:
        """CasADi's C of the closed form; None where CasADi is left out."""
        return next((figure for figure in self.baselines if figure.name == CLOSED), None)

    @property
    def limits(self) -> Mapping[str, float]:
        """Least ns per pose for the operations of the first of ``OURS`` on one core, by what fills a lane."""
        return self.peaks[0].limits(self.ours[0].operations or 0)

    def cycles(self, time: float) -> float:
        """A time, ns, in cycles of the clock."""
        return time / self.cycle.median

    @property
    def compiled(self) -> Measured:
        """All compiled C, as ``shares`` takes it."""
        return Measured(self.builds, self.peaks, self.ours[0].operations or 0)

    def ratios(self, time: float, target: str = "") -> tuple[float | None, float | None]:
        """A time, ns, over the medians of CasADi's closed form and of its plain C; None without CasADi.

        target: whose builds of them; empty for the fastest, which ``baselines`` has.
        """
        built = [self.compiled.fastest(name, target) for name in (CLOSED, PLAIN)]
        both = built if target else [self.closed, self.plain]
        closed, plain = (None if each is None else time / each.median for each in both)
        return closed, plain

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
            "schema": 4,
            "unit": "ns/pose",
            "robot": self.robot,
            "formulation": NAME,
            "rounds": self.rounds,
            "shortest_sample_s": self.shortest_sample,
            "machine": dict(self.machine),
            "software": dict(self.software),
            "clock": dict(self.clock),
            "left_out": list(self.left_out),
            **_measured(ratio_to=None if self.closed is None else [CLOSED, PLAIN]),
            "ours": [self._entry(figure) for figure in self.ours],
            "baselines": [self._entry(figure) for figure in self.baselines],
            "builds": [self._entry(figure, figure.target) for figure in self.builds],
            "shares": [each.as_json() for each in shares(self.compiled)],
            "cores": {**self.cores.as_json(), "unit": "times as fast as one core"},
            "cores_arithmetic": {**self.arithmetic.as_json(), "unit": "times as fast as one core"},
            "parts": {name: [part.as_json() for part in parts] for name, parts in self.parts.items()},
            "calls": [
                {**figure.as_json(), "overhead_over_c_ns": self.overhead(figure)} for figure in self.calls
            ],
            "sweep": [figure.as_json() for figure in self.sweep],
            "flatness": {name: self.flatness(name) for name in dict.fromkeys(f.name for f in self.sweep)},
            "motion": self.motion.as_json(),
            "passes": [each.as_json() for each in self.passes],
            "compiling": [{**each.as_json(), "unit": "s"} for each in self.compiling],
            "text": None if self.text is None else self.text.as_json(),
            "cycle": {**self.cycle.as_json(), "unit": "ns", "clock_GHz": 1 / self.cycle.median},
            "peaks": [self._peak(each) for each in self.peaks],
            "largest_difference": dict(self.differences),
        }

    def _peak(self, peak: Peak) -> dict[str, Any]:
        each = peak.multiply_add.median
        return {
            **peak.multiply_add.as_json(),
            "unit": "ns per fused multiply-add of one number, one core",
            "instructions": peak.target,
            "flags": peak.flags,
            "rate_per_s": 1e9 / each,
            "numbers_in_a_vector": peak.lanes,
            "vectors_in_a_cycle": self.cycle.median / (each * peak.lanes),
            "limits": peak.limits(self.ours[0].operations or 0),
        }

    def _entry(self, figure: Figure, target: str = "") -> dict[str, Any]:
        closed, plain = self.ratios(figure.median, target)
        return {
            **figure.as_json(),
            "cycles": self.cycles(figure.median),
            **_measured(ratio_to_closed_form=closed, ratio_to_casadi=plain),
        }
