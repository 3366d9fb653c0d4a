"""The command ``stewart-sym``: one subcommand for each job.

Reads arguments, calls the library, prints, and turns errors into one line and an exit code: 0 success,
1 ``derive --check`` found differences, 2 anything that could not be done, 128 + n ended by signal n: 130 by
Ctrl-C, 143 by SIGTERM, 129 by SIGHUP. What one needs is imported when it runs, so that none pays for SymPy,
SciPy or Matplotlib but those that use them.
"""

import argparse
import contextlib
import dataclasses
import itertools
import math
import os
import sys
import time
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, NoReturn, TextIO, cast

from ..backend.native import CompilerError
from ..io.blas import take_work_area
from ..io.error_policy import SingularPoseWarning
from ..io.extras import need, needed_for
from ..io.interrupts import as_interrupts, exit_code
from ..io.writing import named

if TYPE_CHECKING:
    from ..identification.estimation import Estimate
    from ..motion.interpolation import Path as MotionPath
    from ..motion.logs import LogFormat
    from ..motion.trajectory import JointTrajectory, PoseLog, Trajectory
    from ..robot.robot import Robot

PROGRAM = "stewart-sym"
ATLAS_CASES = 1_000_000
"""Random cases near failure that the atlas judges."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one subcommand; ``argv``: without the program's name, None for this process's. Returns the code."""
    try:
        arguments = _parser().parse_args(argv)
        take_work_area()
        # An error of the system that names no file is one of printing: all that write files name theirs.
        with named("standard output"):
            with _warnings_in_lines(), as_interrupts(), needed_for(arguments.subcommand):
                code: int = arguments.run(arguments)
            sys.stdout.flush()
        return code
    except BrokenPipeError:
        _give_up_stdout()
        return 2
    except KeyboardInterrupt:
        return exit_code()
    except (ValueError, OSError, ImportError, CompilerError, MemoryError, Warning) as error:
        print(f"{PROGRAM}: error: {_one_line(error)}", file=sys.stderr)
        try:
            sys.stdout.flush()
        except OSError:
            _give_up_stdout()
        return 2


# Subcommands


def _reproduce(arguments: argparse.Namespace) -> int:
    from ..io.writing import replaced_file
    from ..studies.common.output import csv_lines
    from ..studies.paper.report import report
    from ..studies.paper.reproduce import reproduce, run_columns

    if arguments.pictures:
        plots = _plots()
    with _folder(arguments, "report.txt") as folder, _progress() as progress:
        found = reproduce(progress)
        for (path, formulation), run in found.runs.items():
            with replaced_file(folder / f"path_{path}_{formulation}.csv") as stream:
                stream.writelines(csv_lines(run_columns(run)))
        text = report(found)
        (folder / "report.txt").write_text(text, encoding="utf-8", newline="\n")
        if arguments.pictures:
            plots.draw(found, folder, progress)
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0


def _check(arguments: argparse.Namespace) -> int:
    from ..studies.reports.describe import description

    print(description(_robot_of(arguments.robot)))
    return 0


def _forces(arguments: argparse.Namespace) -> int:
    from ..io.writing import replaced_file
    from ..motion.interpolation import between
    from ..motion.trajectory import noise_text
    from ..studies.common.output import csv_lines
    from ..studies.reports.singularities import crossing_warning
    from ..studies.reports.track import Digest, in_parts

    _refuse_overwrite(arguments.output, arguments.robot, arguments.trajectory)
    robot = _robot_of(arguments.robot)
    with replaced_file(arguments.output) as stream, _progress() as progress:
        trajectory = _trajectory(robot, arguments.trajectory, arguments, progress)
        digest, count = Digest(robot, trajectory.time), len(trajectory.time)
        reached = _shares(progress, f"computing {count} instants")
        for part in in_parts(
            robot,
            trajectory,
            arguments.formulation,
            arguments.backend,
            arguments.reactions,
            arguments.allow_singular,
        ):
            stream.writelines(csv_lines(part.columns, header=part.where.start == 0))
            digest.add(part)
            reached(min(1.0, part.where.stop / count))
        if len(trajectory.time) > 1:
            progress("looking for singular poses")
            crossed = crossing_warning(robot, trajectory, between(trajectory))
            if crossed is not None:
                warnings.warn(crossed, SingularPoseWarning, stacklevel=2)
    for line in digest.doubts(arguments.noise_share):
        warnings.warn(line, stacklevel=2)
    if str(arguments.output) != "-":
        print(digest.summary())
        if trajectory.noise is not None and trajectory.noise.sigma.any():
            print(f"{noise_text(trajectory.noise)}: F_sd is what it leaves")
        print(f"Written to {arguments.output}")
    return 0


def _singularities(arguments: argparse.Namespace) -> int:
    from ..io.writing import replaced_file
    from ..kinematics.paths import PATHS, path_for
    from ..motion.interpolation import between
    from ..studies.common.output import csv_lines
    from ..studies.reports import singularities

    if arguments.pictures:
        _plots()
        from ..studies.reports import singularities_plot
    robot = _robot_of(arguments.robot)
    name = arguments.path
    names, read = ("report.txt", "events.csv", "path.csv"), [] if name in PATHS else [Path(name)]
    with _folder(arguments, *names, read=read) as folder, _progress() as progress:
        if name in PATHS:
            if arguments.start is not None:
                raise ValueError("--start: is for a trajectory of leg lengths, this one is of poses")
            line = path_for(robot, name).path
            path: MotionPath = line.sample
            times = line.breaks()
        else:
            if not Path(name).exists():
                raise ValueError(f"{name}: expected I, II, III or a CSV file, there is no such file")
            trajectory = _trajectory(robot, Path(name), arguments, progress)
            path, times, name = between(trajectory), trajectory.time, Path(name).name
        progress("looking for singular poses")
        found = singularities.examine(robot, name, path, times, arguments.formulation)
        text = singularities.report(found)
        (folder / "report.txt").write_text(text + "\n", encoding="utf-8", newline="\n")
        tables = {"events": singularities.events(found), "path": singularities.curves(found)}
        for table, columns in tables.items():
            with replaced_file(folder / f"{table}.csv") as stream:
                stream.writelines(csv_lines(columns))
        if arguments.pictures:
            progress("drawing")
            singularities_plot.draw(found, folder)
        written = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(written)}")
    return 0


def _derive(arguments: argparse.Namespace) -> int:
    from ..io.writing import staged_folder

    directory = arguments.output or _generated_folder()
    if arguments.check:
        if not directory.is_dir():
            raise NotADirectoryError(20, "expected a folder of generated files", str(directory))
        return _compare(directory, _derived())
    own = arguments.output is None
    with staged_folder(directory) if own else _folder(arguments) as folder:
        texts = _derived()
        for name, text in texts.items():
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8", newline="\n")
    print(f"{len(texts)} files written to {directory}")
    return 0


def _generate(arguments: argparse.Namespace) -> int:
    from ..kit import Choice, kit_names, write_kit

    robot = _robot_of(arguments.robot)
    names = ("formulation", "fidelity", "bake", "scalar", "precision", "fmu", "language")
    functions = tuple(name.strip() for name in arguments.functions.split(","))
    choice = Choice(functions, **{name: getattr(arguments, name) for name in names})
    if arguments.list:
        for name in kit_names(robot, choice):
            print(arguments.output / name)
        return 0
    with _progress() as progress:
        progress("generating")
        made, written = write_kit(robot, arguments.output, choice, arguments.force, [Path(arguments.robot)])
    for path in written:
        print(path)
    if made.operations is not None:
        after = made.baked_operations
        folded = "" if after is None else f", with the numbers folded in {after}"
        print(f"operations per pose: {made.operations}{folded}")
    return 0


def _cmake_dir(arguments: argparse.Namespace) -> int:
    print(Path(str(files("stewart_sym"))) / "cmake")
    return 0


def _identify(arguments: argparse.Namespace) -> int:
    from ..studies.reports.identify import doubts

    with _folder(arguments, "report.txt", "trajectory.csv") as folder, _progress() as progress:
        progress("identifying")
        read = _measured if arguments.measured else _simulated
        texts, found = read(arguments, progress)
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8", newline="\n")
    print(texts["report.txt"])
    print(f"Written to {arguments.output}: {', '.join(sorted(texts))}")
    for line in doubts(found):
        warnings.warn(line, stacklevel=2)
    return 1 if found.verdict == "rejected" else 0


def _bench(arguments: argparse.Namespace) -> int:
    import json

    from ..studies.benchmark import bench, plot

    robot = None if arguments.robot is None else _robot_of(arguments.robot)
    with _folder(arguments, "bench.txt", "bench.json") as folder:
        with _progress() as progress:
            found = bench.bench(robot, arguments.quick, progress)
            progress("drawing")
            plot.draw(found, folder)
        text = plot.report(found)
        (folder / "bench.txt").write_text(text, encoding="utf-8", newline="\n")
        figures = json.dumps(found.as_json(), indent=1) + "\n"
        (folder / "bench.json").write_text(figures, encoding="utf-8", newline="\n")
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0


def _simulate(arguments: argparse.Namespace) -> int:
    from ..io.writing import replaced_file
    from ..simulation.scene import read_scene
    from ..studies.common.output import csv_lines
    from ..studies.reports import energy_drift, run

    need("scipy", "simulation")
    if arguments.pictures:
        _plots()
    scene = read_scene(arguments.scene)
    _warn_of_doubts(scene.robot, arguments.scene)
    springs = energy_drift.springs_of(scene) if arguments.energy_drift else None
    with _folder(arguments, "summary.txt", "run.csv", read=scene.files) as folder, _progress() as progress:
        done = scene.run(_shares(progress, "simulating"))
        tables = {"run": run.run_columns(done)}
        text = run.summary(done, scene.law)
        drifts = {}
        if springs is not None:
            progress("comparing the formulations")
            drifts = energy_drift.energy_drift(
                springs, scene.state, scene.duration, scene.rtol, scene.thresholds
            )
            tables |= {f"energy_drift_{name}": drift.columns() for name, drift in drifts.items()}
            text += "\n" + energy_drift.summary(drifts)
        for name, columns in tables.items():
            with replaced_file(folder / f"{name}.csv") as stream:
                stream.writelines(csv_lines(columns))
        (folder / "summary.txt").write_text(text + "\n", encoding="utf-8", newline="\n")
        if arguments.pictures:
            progress("drawing")
            pictures = {"run": run.figure(done)} | (
                {"energy_drift": energy_drift.figure(drifts)} if drifts else {}
            )
            for name, picture in pictures.items():
                if picture is None:
                    warnings.warn(f"{name}.png: not drawn, the run ended where it began", stacklevel=2)
                else:
                    run.save(picture, folder / f"{name}.png")
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0


def _control(arguments: argparse.Namespace) -> int:
    import json

    from ..io.writing import replaced_file
    from ..studies.common.output import csv_lines
    from ..studies.control import control
    from ..studies.control import report as control_report
    from ..studies.reports import run

    if arguments.pictures:
        _plots()
    machines = control.papers_machines()
    if arguments.robot is not None:
        machines = {"robot": _robot_of(arguments.robot)}
    paths = control.TRACKED if arguments.path is None else (arguments.path,)
    settings = control.Settings(rate=arguments.rate)
    with _folder(arguments, "control.txt", "control.csv", "control.json") as folder, _progress() as progress:
        studies = {
            label: control.track_paths(robot, paths, settings, progress) for label, robot in machines.items()
        }
        text = control_report.report(studies)
        figures = json.dumps(control_report.as_json(studies), indent=1) + "\n"
        texts = {"txt": text + "\n", "csv": control_report.csv_rows(studies), "json": figures}
        for kind, content in texts.items():
            (folder / f"control.{kind}").write_text(content, encoding="utf-8", newline="\n")
        for number, (label, study) in enumerate(studies.items()):
            suffix = f"_{label}" if number else ""
            for path, runs in study.runs.items():
                with replaced_file(folder / f"path_{path}{suffix}.csv") as stream:
                    stream.writelines(csv_lines(control_report.run_columns(runs)))
            if arguments.pictures:
                progress("drawing")
                run.save(control_report.figure(study), folder / f"control{suffix}.png")
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    for study in studies.values():
        for line in study.exceeded:
            warnings.warn(line, stacklevel=2)
    return 0


def _controller(arguments: argparse.Namespace) -> int:
    from ..studies.microcontroller import measure, report
    from ..studies.paper.reproduce import paper_machine

    robot = paper_machine() if arguments.robot is None else _robot_of(arguments.robot)
    with contextlib.ExitStack() as stack:
        folder = (
            None
            if arguments.output is None
            else stack.enter_context(_folder(arguments, "controller.txt", "controller.json"))
        )
        with _progress() as progress:
            found = measure.study(robot, progress, arguments.fidelity)
        text = report.report(found)
        if folder is not None:
            for kind, content in (("txt", text + "\n"), ("json", report.json_text(found))):
                (folder / f"controller.{kind}").write_text(content, encoding="utf-8", newline="\n")
    print(text)
    if arguments.output is not None:
        print(f"\nWritten to {arguments.output}: controller.json, controller.txt")
    return 0 if all(row.right for row in found.rows) else 2


def _stability(arguments: argparse.Namespace) -> int:
    import json

    from ..io.writing import replaced_file
    from ..studies.common.output import csv_lines
    from ..studies.robustness.sweep.sweep import report, sweep

    if arguments.cases is not None and arguments.output is None:
        with _progress() as progress:
            swept = sweep(arguments.cases, arguments.seed, progress)
        print(report(swept))
        return 1 if swept.wrong or swept.refused_good else 0
    if arguments.pictures:
        _plots()
    from ..studies.robustness import atlas

    output = arguments.output = arguments.output or Path("stability")
    with _folder(arguments, "stability.txt", "stability.json") as folder, _progress() as progress:
        found = atlas.atlas(progress)
        cases = ATLAS_CASES if arguments.cases is None else arguments.cases
        found = dataclasses.replace(found, sweep=sweep(cases, arguments.seed, progress))
        for family in found.families:
            with replaced_file(folder / f"{family.name}.csv") as stream:
                stream.writelines(csv_lines(family.columns()))
        text = atlas.report(found)
        (folder / "stability.txt").write_text(text + "\n", encoding="utf-8", newline="\n")
        figures = json.dumps(atlas.as_json(found), indent=1, allow_nan=False) + "\n"
        (folder / "stability.json").write_text(figures, encoding="utf-8", newline="\n")
        if arguments.pictures:
            from ..studies.robustness import pictures

            progress("drawing")
            pictures.draw(found, folder)
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {output}: {', '.join(names)}")
    return 0


def _advise(arguments: argparse.Namespace) -> int:
    import json

    from ..io.writing import replaced_file
    from ..kit import Choice, write_kit
    from ..studies.accuracy import advice
    from ..studies.accuracy.budget import read_budget
    from ..studies.accuracy.cost import economy

    budget = read_budget(arguments.scene)
    if arguments.json is not None:
        _refuse_overwrite(arguments.json, *budget.files)
    _warn_of_doubts(budget.robot, arguments.scene)
    with contextlib.ExitStack() as opened, _progress() as progress:
        stream = None if arguments.json is None else opened.enter_context(replaced_file(arguments.json))
        found = advice.advice(economy(budget.robot, budget.motions, progress=progress), budget)
        if stream is not None:
            stream.write(json.dumps(advice.as_json(found), indent=1) + "\n")
        written: list[Path] = []
        if arguments.generate is not None and found.chosen is not None:
            progress("generating")
            it = found.chosen.candidate
            choice = Choice(
                formulation=it.formulation,
                fidelity=it.fidelity,
                bake=arguments.bake,
                precision=it.precision,
            )
            _, written = write_kit(budget.robot, arguments.generate, choice, arguments.force, budget.files)
    print(advice.report(found))
    for path in written:
        print(path)
    if found.chosen is None:
        raise ValueError(f"{arguments.scene}: nothing keeps the budget; closest: {advice.closest(found)}")
    return 0


def _chart(arguments: argparse.Namespace) -> int:
    import json

    from ..studies.accuracy.advice import table
    from ..studies.accuracy.budget import papers_motions, read_budget
    from ..studies.accuracy.charts import charts
    from ..studies.accuracy.cost import ROUNDS, economy
    from ..studies.accuracy.cost_plot import save
    from ..studies.common import host
    from ..studies.paper.reproduce import paper_machine

    if arguments.pictures:
        _plots()
    robot, motions = paper_machine(), papers_motions()
    read: tuple[Path, ...] = ()
    if arguments.scene is not None:
        scene = read_budget(arguments.scene)
        robot, motions, read = scene.robot, dict(scene.motions), scene.files
        _warn_of_doubts(robot, arguments.scene)
    with _folder(arguments, "chart.txt", "chart.json", read=read) as folder, _progress() as progress:
        found = economy(robot, motions, True, ROUNDS, progress)
        text = table(found)
        figures = {**found.as_json(), "machine": host.machine(), "software": host.software()}
        texts = {"chart.txt": text + "\n", "chart.json": json.dumps(figures, indent=1) + "\n"}
        every = list(charts(found, robot, progress))
        texts |= {f"{chart.name}.csv": chart.rows for chart in every}
        for name, content in texts.items():
            (folder / name).write_text(content, encoding="utf-8", newline="\n")
        if arguments.pictures:
            progress("drawing")
            for chart in every:
                save(chart.draw(), folder / chart.name)
        names = sorted(path.name for path in folder.iterdir())
    print(text)
    print(f"Written to {arguments.output}: {', '.join(names)}")
    return 0


# Their parts


def _robot_of(source: Path) -> "Robot":
    """The robot of a file; warns of what is doubtful about it."""
    from ..robot.robot import Robot

    robot = Robot.from_toml(source)
    _warn_of_doubts(robot, source)
    return robot


def _warn_of_doubts(robot: "Robot", source: Path) -> None:
    """Warn of a robot's doubtful numbers, in one line each; ``source``: the file that gives or names it."""
    from ..plausibility.plausibility import doubts
    from ..robot.robot import PhysicalityWarning

    for name, text in doubts(robot):
        warnings.warn(f"{source}: {text} [{name}]", PhysicalityWarning, stacklevel=3)


def _trajectory(
    robot: "Robot", source: Path, arguments: argparse.Namespace, progress: Callable[[str], None]
) -> "Trajectory | PoseLog":
    """Poses over time from a CSV file of poses or of leg lengths, read as the options say."""
    from ..motion.interpolation import resampled
    from ..motion.trajectory import Smoothing, read_log

    progress("reading the trajectory")
    smoothing = Smoothing(
        arguments.noise_position, arguments.noise_angle, arguments.cutoff, arguments.smoothing
    )
    trajectory = _poses(robot, read_log(source, _form(arguments), smoothing), arguments.start, progress)
    return trajectory if arguments.rate is None else resampled(trajectory, arguments.rate)


def _form(arguments: argparse.Namespace) -> "LogFormat":
    from ..motion.logs import LogFormat

    names = ("columns", "length_unit", "angle_unit", "time_unit", "delimiter", "decimal", "euler_order")
    return LogFormat(**{name: getattr(arguments, name) for name in names})


# Instants that show on which side of the base a platform is.
_SOME = 64


def _poses(
    robot: "Robot",
    log: "Trajectory | PoseLog | JointTrajectory",
    start: list[float] | None,
    progress: Callable[[str], None],
) -> "Trajectory | PoseLog":
    """Poses of a log, found from leg lengths if it holds these."""
    import numpy as np

    from ..motion.rotation import rotation_from_rpy
    from ..motion.trajectory import JointTrajectory, PoseLog
    from ..singularities.joint_space import on_platform
    from ..studies.reports.track import length_doubt, side_doubt

    if isinstance(log, JointTrajectory):
        distances = log.L
    else:
        places = log.coordinates[0, :, :3] if isinstance(log, PoseLog) else log.motion.t
        distances = np.linalg.norm(places, axis=-1)
    doubt = length_doubt(robot, distances)
    if doubt is not None:
        warnings.warn(f"{log.source}: {doubt}", stacklevel=2)
    if isinstance(log, JointTrajectory):
        progress(f"finding {len(log.time)} poses")
        guess = None if start is None else (rotation_from_rpy(start[3:]), start[:3])
        return on_platform(robot, log, guess)
    if start is not None:
        raise ValueError("--start: is for a trajectory of leg lengths, this one is of poses")
    some = np.linspace(0, len(log.time) - 1, min(len(log.time), _SOME)).astype(np.int64)
    below = side_doubt(robot, log.at(some))
    if below is not None:
        warnings.warn(f"{log.source}: {below}", stacklevel=2)
    return log


def _measured(
    arguments: argparse.Namespace, progress: Callable[[str], None]
) -> "tuple[dict[str, str], Estimate]":
    """Texts of the files about measured forces, by name, and the estimate."""
    from ..identification.physical import POSSIBLE
    from ..motion.logs import HeaderError
    from ..motion.smooth_motion import WITHOUT_PERIOD, PoseNoise
    from ..motion.trajectory import FORCES, Smoothing, read_any_csv, read_forces_csv
    from ..studies.reports.identify import from_measurement, measured_texts

    if arguments.physical:
        need("scipy", POSSIBLE)
    noisy = _pose_noise(arguments)
    if noisy and arguments.period is None:
        need("scipy", WITHOUT_PERIOD)
    robot = _robot_of(arguments.robot)
    poses, forces = arguments.measured
    form = _form(arguments)
    try:
        log = read_any_csv(poses, form, Smoothing(on=False))  # the fit has its own noise
    except HeaderError as error:
        if not set(FORCES) <= set(error.header):
            raise
        raise ValueError(
            f"{poses}: expected poses or leg lengths, got forces F1 to F6: "
            "the two files of --measured look swapped"
        ) from None
    trajectory = cast("Trajectory", _poses(robot, log, arguments.start, progress))
    time, F = read_forces_csv(forces, dataclasses.replace(form, columns={}))
    noise = None
    if noisy:
        series = (arguments.period, arguments.harmonics if arguments.period is not None else None)
        noise = PoseNoise(trajectory.time, arguments.noise_position, arguments.noise_angle, *series)
    model = (not arguments.no_friction, arguments.physical)
    found = from_measurement(robot, trajectory, time, F, arguments.sigma, str(forces), noise, *model)
    return measured_texts(robot, found, arguments.sigma, noise), found


def _simulated(
    arguments: argparse.Namespace, progress: Callable[[str], None]
) -> "tuple[dict[str, str], Estimate]":
    """Texts of the files about a simulated measurement, by name, and the estimate."""
    from ..motion.logs import LogFormat
    from ..studies.reports.identify import identification, simulated_texts

    for option in ("no_friction", "physical"):
        if getattr(arguments, option):
            raise ValueError(f"--{option.replace('_', '-')}: is for measured forces, expected --measured")
    if _form(arguments) != LogFormat() or arguments.start is not None:
        raise ValueError(
            "--start and options of the trajectory's file: are for measured forces, expected --measured"
        )
    robot = _robot_of(arguments.robot)
    names = ("sigma", "seed", "period", "harmonics", "samples", "candidates")
    options = {name: getattr(arguments, name) for name in names}
    if options["harmonics"] is None:
        options["harmonics"] = 5
    if _pose_noise(arguments):
        options |= {name: getattr(arguments, name) for name in ("noise_position", "noise_angle")}
    found = identification(robot, **options, progress=progress)
    return simulated_texts(robot, found), found.estimate


def _pose_noise(arguments: argparse.Namespace) -> bool:
    """Whether the noise of poses is stated: both of it or neither."""
    given = [getattr(arguments, name) is not None for name in ("noise_position", "noise_angle")]
    if given[0] != given[1]:
        raise ValueError("--noise-position: expected --noise-angle beside it, and none without it")
    return given[0]


def _plots() -> ModuleType:
    with needed_for("drawing", ", or give --no-pictures"):
        import matplotlib  # noqa: F401
    from ..studies.paper import plots

    return plots


def _generated_folder() -> Path:
    return Path(str(files("stewart_sym.generated")))


def _derived() -> dict[str, str]:
    """Derive every kernel and print what was derived, how long it took and what it costs."""
    from ..derive.generate import generated_files

    starts: list[tuple[str, float]] = []
    with _progress() as progress:

        def note(text: str) -> None:
            progress(text)
            starts.append((text, time.perf_counter()))

        texts: dict[str, str] = generated_files(note)
    ends = [start for _, start in starts[1:]] + [time.perf_counter()]
    for (text, start), end in zip(starts, ends, strict=True):
        name = text.removeprefix("deriving ")
        counts = _operations(texts.get(f"{name}.py", ""))
        print(f"{name:<16} {end - start:6.1f} s   {counts}".rstrip())
    return texts


def _operations(module: str) -> str:
    """Totals in the text of a generated module, in words; empty if it has none."""
    import ast

    for node in ast.parse(module).body:
        if isinstance(node, ast.AnnAssign) and ast.unparse(node.target) == "OPERATIONS" and node.value:
            counts = ast.literal_eval(node.value)
            with_friction, without = (sum(counts[key]["total"]) for key in ("friction", "frictionless"))
            return f"operations per pose: {with_friction} with friction, {without} without"
    return ""


def _compare(directory: Path, texts: dict[str, str]) -> int:
    """Name the files that differ, are missing or are not generated; 1 if there are any."""
    present = {
        path.relative_to(directory).as_posix()
        for pattern in ("*.py", "c/*.[ch]")
        for path in directory.glob(pattern)
    }
    different = [name for name in sorted(texts) if _differs(directory / name, texts[name])]
    stray = sorted(present - texts.keys())
    for name in different:
        print(f"differs: {name}" if name in present else f"missing: {name}")
    for name in stray:
        print(f"not generated: {name}")
    if different or stray:
        return 1
    print(f"{directory}: all {len(texts)} files are as derived")
    return 0


def _differs(path: Path, text: str) -> bool:
    try:
        return path.read_bytes() != text.encode("utf-8")
    except FileNotFoundError:
        return True


def _folder(
    arguments: argparse.Namespace, *names: str, read: Iterable[Path] = ()
) -> contextlib.AbstractContextManager[Path]:
    """The folder of a subcommand's results.

    names: of files in it, so that a clash is said at once. read: inputs that are no arguments by themselves.
    """
    from ..io.writing import result_folder

    given = (value if isinstance(value, list) else [value] for value in vars(arguments).values())
    inputs = [path for path in itertools.chain(*given) if isinstance(path, Path) and path != arguments.output]
    return result_folder(arguments.output, arguments.force, [*inputs, *read], names)


def _refuse_overwrite(output: Path, *inputs: Path) -> None:
    for path in inputs:
        if output.exists() and path.exists() and output.samefile(path):
            raise ValueError(f"-o {output}: is an input, name another file")


# Talking to the user


def _give_up_stdout() -> None:
    """Its reader has gone or its disk is full: the interpreter's own flush at exit must not complain."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextlib.contextmanager
def _progress() -> Iterator[Callable[[str], None]]:
    """Show what is being done in one line of a terminal, gone at the end; nothing in a pipe."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    try:
        yield lambda text: print(f"\r\x1b[K{text} ...", end="", file=sys.stderr, flush=True)
    finally:
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def _shares(progress: Callable[[str], None], text: str) -> Callable[[float], None]:
    """Show the share of a task that is done, 0 to 1, and the time left at that pace, five times a second."""
    began = shown = time.monotonic()
    progress(text)

    def reached(share: float) -> None:
        nonlocal shown
        now = time.monotonic()
        if share > 0.0 and now - shown >= 0.2:
            shown = now
            left = (now - began) * (1.0 - share) / share
            progress(f"{text}, {100.0 * share:.0f} %, {left:.0f} s left")

    return reached


@contextlib.contextmanager
def _warnings_in_lines() -> Iterator[None]:
    """Show the block's warnings at its end, one line each; those of an error come before it."""
    lines: list[str] = []

    def keep(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        file: TextIO | None = None,
        line: str | None = None,
    ) -> None:
        lines.append(_one_line(message))

    with warnings.catch_warnings():
        warnings.showwarning = keep
        try:
            yield
        finally:
            for text in lines:
                print(f"{PROGRAM}: warning: {text}", file=sys.stderr)


def _one_line(error: object) -> str:
    if isinstance(error, MemoryError):
        return f"out of memory: {error}" if str(error) else "out of memory"
    if isinstance(error, OSError) and error.strerror:
        text = error.strerror if error.filename is None else f"{error.filename}: {error.strerror}"
    else:
        text = str(error) or type(error).__name__
    return " ".join(text.split())


# The command line


class _Parser(argparse.ArgumentParser):
    """Tells of a wrong command in one line."""

    def error(self, message: str) -> NoReturn:
        """Exit with code 2."""
        self.exit(2, f"{PROGRAM}: error: {_one_line(message)} (see {self.prog} --help)\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog=PROGRAM,
        description="Dynamics of the Stewart platform: derived by SymPy, emitted as C and NumPy, checked.",
        epilog="Example: stewart-sym reproduce -o reproduce",
    )
    parser.add_argument("--version", action="version", version=f"{PROGRAM} {version('stewart-sym')}")
    verbs = parser.add_subparsers(title="subcommands", metavar="SUBCOMMAND", required=True)

    verb = _verb(
        verbs,
        "reproduce",
        _reproduce,
        "compute section 5 of the paper again: tables, CSV, and the pictures of Figs. 4-10",
        "stewart-sym reproduce -o reproduce",
    )
    _output(verb, "DIR", "folder to write to", Path("reproduce"))
    verb.add_argument(
        "--no-pictures", dest="pictures", action="store_false", help="tables and CSV only, without Matplotlib"
    )

    verb = _verb(
        verbs,
        "check",
        _check,
        "validate and describe a robot file",
        "stewart-sym check hexapod.toml",
        "SI units. Base points, fixed axes and gravity are in the base frame, platform points and the "
        "platform's body in the platform frame, whose origin is yours to choose. Lower parts are measured "
        "from the base point, upper parts from the platform point, x along the leg. Frames, signs and "
        "rotation order with a drawing: .docs/conventions.md of the source.",
    )
    _robot(verb)

    verb = _verb(
        verbs,
        "forces",
        _forces,
        "actuator forces along a trajectory",
        "stewart-sym forces hexapod.toml log.csv -o forces.csv --length-unit mm --angle-unit deg",
        "The trajectory's first line names its columns: time, t_x t_y t_z (m), theta_x theta_y theta_z "
        "(rad) or q_w q_x q_y q_z; optionally v_*, theta_dot_*, a_* and theta_ddot_* together (else a spline "
        "is fitted), F_ext_* and M_ext_* (platform frame). Or, in joint space: time, L_1 to L_6 (m), "
        "optionally L_dot_* and L_ddot_* together. SI units by default. Columns that show rounding or noise "
        "are smoothed, F1_sd to F6_sd are the standard deviations of the forces that this leaves, and a "
        "force limit within three of them is not decided. Moments M_p are taken about the base points.",
    )
    _robot(verb)
    verb.add_argument(
        "trajectory", metavar="TRAJECTORY.csv", type=Path, help="times and poses, or leg lengths"
    )
    _output(verb, "FILE.csv", "file to write, - for standard output", None)
    _formulation(verb)
    verb.add_argument("--backend", choices=("c", "numpy", "reference"), default="c", help="default: c")
    verb.add_argument("--reactions", action="store_true", help="write the joint reactions as well")
    _start(verb)
    verb.add_argument(
        "--allow-singular",
        action="store_true",
        help="write nan and a status for unsolvable poses instead of rejecting the trajectory",
    )
    verb.add_argument(
        "--noise-share",
        type=_positive,
        default=0.02,
        metavar="SHARE",
        help="of a leg's peak force that noise may make (three deviations) without a warning; default: 0.02",
    )
    _log(verb)

    verb = _verb(
        verbs,
        "singularities",
        _singularities,
        "where a path crosses singular poses, between samples too, and which twist is unconstrained there",
        "stewart-sym singularities hexapod.toml trajectory.csv -o singularities",
        "Writes a report, tables of events and of the path, and pictures of forces and of the machine with "
        "the unconstrained twist. Between the rows of a trajectory the path is the quintic through their "
        "poses, rates and accelerations. SI units.",
    )
    _robot(verb)
    verb.add_argument("path", metavar="PATH", help="I, II or III of the paper, or a CSV file as for forces")
    _output(verb, "DIR", "folder to write to", Path("singularities"))
    _formulation(verb)
    _start(verb)
    _log(verb)
    verb.add_argument(
        "--no-pictures",
        dest="pictures",
        action="store_false",
        help="no pictures, no Matplotlib",
    )

    verb = _verb(
        verbs,
        "simulate",
        _simulate,
        "let a machine move under its legs' forces: a table, a summary and pictures",
        "stewart-sym simulate swing.toml -o swing",
        "The scene is a TOML file: schema = 1, robot (a file beside it), duration (s), and if you like "
        "formulation, output_step (s), method, rtol. [state]: t, theta (roll, pitch, yaw), v, omega. [load]: "
        "F_ext, M_ext, platform frame. [thresholds]: max_condition, min_length, min_pole_sine. [legs]: law = "
        '"forces" with forces; "springs" with stiffness, damping, rest_length (without it they balance the '
        'weight at the start); "tracking" by computed torque with path (I, II, III or a CSV file as for '
        "`forces`), gains k_p and k_d, model, rate (Hz). SI units. A run stops where a leg reaches a limit.",
    )
    verb.add_argument("scene", metavar="SCENE.toml", type=Path, help="scene file, schema 1")
    _output(verb, "DIR", "folder to write to", Path("simulation"))
    verb.add_argument(
        "--energy-drift",
        action="store_true",
        help="compare the energy in both formulations, without friction and dampers (springs only)",
    )
    verb.add_argument(
        "--no-pictures", dest="pictures", action="store_false", help="tables only, without Matplotlib"
    )

    verb = _verb(
        verbs,
        "control",
        _control,
        "track the paper's paths with controllers that differ in their model: table, CSV, JSON, pictures",
        "stewart-sym control -o control --path II",
        "The plant is `exact`; forces are held between samples. Computed torque by `exact`, by `paper` and "
        "by the platform alone (massless legs), and PD with gravity compensation: the same gains, the same "
        "start a little off the path. Without --robot: the paper's machine, as printed and with friction "
        "that counts. Takes about half a minute.",
    )
    _output(verb, "DIR", "folder to write to", Path("control"))
    verb.add_argument("--path", choices=("I", "II"), help="track this path alone; default: both")
    verb.add_argument(
        "--robot", metavar="ROBOT.toml", type=Path, help="robot file, schema 1; default: the paper's machine"
    )
    verb.add_argument(
        "--rate", metavar="HZ", type=_positive, default=1000.0, help="of the controllers, Hz; default: 1000"
    )
    verb.add_argument(
        "--no-pictures", dest="pictures", action="store_false", help="tables only, without Matplotlib"
    )

    verb = _verb(
        verbs,
        "controller",
        _controller,
        "kernels for a machine on a microcontroller, under emulation: answers, instructions, flash, stack",
        "stewart-sym controller hexapod.toml -o controller",
        "Writes one-pose kernels, general and with the machine's numbers folded in, cross-compiles them for "
        "Arm Cortex-M7 (double) and Cortex-M4F (float) and runs them under QEMU: forces against 50-digit "
        "ones, statuses of wrong calls, executed instructions, stack; flash, and what the objects ask of "
        "libraries. Needs arm-none-eabi-gcc with newlib and qemu-system-arm (Debian: gcc-arm-none-eabi, "
        "libnewlib-arm-none-eabi, qemu-system-arm). Exit code 2 where anything is not right. Takes some ten "
        "seconds.",
    )
    verb.add_argument(
        "robot",
        metavar="ROBOT.toml",
        type=Path,
        nargs="?",
        help="robot file, schema 1; default: the paper's machine",
    )
    _output(verb, "DIR", "folder for the table and controller.json", "none written")
    verb.add_argument(
        "--fidelity", metavar="LEVEL", default="general", help="as of `generate`; default: general"
    )

    verb = _verb(
        verbs,
        "advise",
        _advise,
        "the cheapest kernel that is good enough for a machine's motions, and what physics it needs",
        "stewart-sym advise enough.toml --generate kernel",
        'The scene is a TOML file: schema = 1, robot (a file beside it), motions (a list of "I", "II", "III" '
        "and of CSV files as for `forces`), tolerance (of the forces, share of a motion's peak force), if "
        "you like margin (default 3: errors times this must be within the tolerance) and rate (Hz: a pose "
        "alone must not take longer). Runs the motions at every fidelity, formulation and precision; the "
        "cheapest is the one with the fewest operations, float before double. Rounding is measured at 12 "
        "poses spread over each motion and at its hardest, the model at all poses. Exit code 2 where nothing "
        "is good enough. Takes half a minute, less when the kernels are compiled.",
    )
    verb.add_argument("scene", metavar="SCENE.toml", type=Path, help="scene file, schema 1")
    verb.add_argument("--json", metavar="FILE", type=_path, help="write all figures and the answer to a file")
    verb.add_argument(
        "--generate", metavar="DIR", type=_path, help="write the chosen kernel for this robot, as generate"
    )
    verb.add_argument("--bake", action="store_true", help="fold the robot's numbers into that kernel")
    _force(verb)

    verb = _verb(
        verbs,
        "chart",
        _chart,
        "draw time per pose over error, of the model and of rounding: pictures, CSV, JSON, table",
        "stewart-sym chart enough.toml -o chart",
        "chart.png: every fidelity and implementation is a point; scales.png: rounding over size and mass of "
        "machines like this one; bounds.png: rounding and its bound. Each as SVG and CSV, too. The scene is "
        "one of `advise`; without it: the paper's machine on its Paths I, II and III. Takes about a minute.",
    )
    verb.add_argument("scene", metavar="SCENE.toml", type=Path, nargs="?", help="scene file, schema 1")
    _output(verb, "DIR", "folder to write to", Path("chart"))
    verb.add_argument(
        "--no-pictures", dest="pictures", action="store_false", help="tables only, without Matplotlib"
    )

    verb = _verb(
        verbs, "derive", _derive, "derive the kernels again and write them", "stewart-sym derive --check"
    )
    _output(verb, "DIR", "folder to write to", "the installed kernels")
    verb.add_argument(
        "--check", action="store_true", help="write nothing; exit 1 with the names of files that differ"
    )

    verb = _verb(
        verbs,
        "generate",
        _generate,
        "write a kit of one robot in C, Python, MATLAB or Rust: kernels, constants, self-test, example",
        "stewart-sym generate hexapod.toml -o kit --functions forces,kinematics && make -C kit",
        "The kit proves itself where it runs: in C, `make` builds it and runs its self-test; in another "
        "language its README names the command.",
    )
    _robot(verb)
    _output(verb, "DIR", "folder to write to", None)
    verb.add_argument(
        "--functions",
        metavar="LIST",
        default="forces",
        help="some of forces, reactions (in C alone), motion (M, C, g, friction, bias, H, forward dynamics, "
        "inertia at the actuators), derivatives (of the forces; linearisation), kinematics (inverse, "
        "forward, velocities), with commas; default: forces",
    )
    _formulation(verb)
    verb.add_argument(
        "--fidelity",
        metavar="LEVEL",
        help="how much of the legs' physics the forces know: general, frictionless, axisymmetric, slender, "
        "point_masses, massless, the last four also with _friction; general_static, slender_static, "
        "massless_static",
    )
    verb.add_argument("--bake", action="store_true", help="fold the robot's numbers into the forces")
    verb.add_argument(
        "--scalar",
        action="store_true",
        help="forces of one pose, legs one after the other: for processors without vector registers",
    )
    verb.add_argument("--precision", choices=("double", "float"), default="double", help="default: double")
    verb.add_argument("--fmu", action="store_true", help="add a co-simulation unit, FMI 2.0, of the forces")
    verb.add_argument(
        "--language",
        default="c",
        help="c; python: one module on arrays of NumPy, JAX, PyTorch; matlab: a package of functions, for "
        "Octave as well; rust: a crate, without its standard library as well; each with the robot's "
        "constants, self-test, example and README, of forces, motion, derivatives, kinematics; default: c",
    )
    verb.add_argument("--list", action="store_true", help="print the names of the files, write none")

    _verb(
        verbs,
        "cmake-dir",
        _cmake_dir,
        "print the folder of the CMake package that brings stewart_generate()",
        "cmake -S . -B build -Dstewart-sym_DIR=$(stewart-sym cmake-dir)",
    )

    verb = _verb(
        verbs,
        "identify",
        _identify,
        "identify inertial parameters from measured forces, or show it on a simulated measurement",
        "stewart-sym identify hexapod.toml --sigma 0.5 -o identified",
        "Without --measured the motion is the best of random Fourier series about the home pose, within the "
        "limits of length, speed and force in the robot file, and the table gives the true values as well. "
        "SI units.",
    )
    _robot(verb)
    _output(verb, "DIR", "folder to write to", None)
    verb.add_argument(
        "--measured",
        nargs=2,
        type=Path,
        metavar=("TRAJECTORY.csv", "FORCES.csv"),
        help="the motion, as for forces, and columns time, F1 to F6 (N) at the same times; of the robot file "
        "only geometry and gravity are used; --seed, --samples and --candidates have no part in it",
    )
    verb.add_argument(
        "--sigma", type=_positive, default=1.0, help="standard deviation of measured forces, N; default: 1"
    )
    for name, unit, what in (("position", "M", "position"), ("angle", "RAD", "rotation about each axis")):
        verb.add_argument(
            f"--noise-{name}",
            type=_positive,
            metavar=unit,
            help=f"standard deviation of the measured {what}: then poses alone count, and a smooth motion is "
            "fitted together with the parameters; default: the motion is exact",
        )
    verb.add_argument("--seed", type=_whole, default=0, help="of the candidates and of the noise; default: 0")
    verb.add_argument(
        "--period",
        type=_finite,
        help="of the motion, s; default: accelerations of the order of gravity, or for measured poses with "
        "noise a motion without a period",
    )
    verb.add_argument(
        "--harmonics",
        type=_whole,
        help="of the Fourier series; default: 5, or for measured poses as many as they call for",
    )
    verb.add_argument(
        "--no-friction", action="store_true", help="of measured forces: a model whose joints have none"
    )
    verb.add_argument(
        "--physical",
        action="store_true",
        help="of measured forces: keep to bodies that can exist, and write their parameters to bodies.csv",
    )
    verb.add_argument("--samples", type=_whole, default=200, help="instants of one period; default: 200")
    verb.add_argument("--candidates", type=_whole, default=50, help="random series to try; default: 50")
    _start(verb)
    _log_form(verb)

    verb = _verb(
        verbs,
        "bench",
        _bench,
        "time the kernels beside CasADi, Pinocchio, MuJoCo and the processor's limit: tables, JSON, pictures",
        "stewart-sym bench -o bench",
        "Answers are compared before anything is timed. Of CasADi, Pinocchio and MuJoCo, the extra bench, "
        "what is not installed is left out. Takes a minute or two on an otherwise idle machine.",
    )
    _output(verb, "DIR", "folder to write to", Path("bench"))
    verb.add_argument("--quick", action="store_true", help="fewer rounds and smaller batches")
    verb.add_argument(
        "--robot", metavar="ROBOT.toml", type=Path, help="robot file, schema 1; default: the paper's machine"
    )

    verb = _verb(
        verbs,
        "stability",
        _stability,
        "approach every degenerate configuration with every method: tables, CSV, JSON, pictures",
        "stewart-sym stability -o stability",
        "Errors are against 50-digit arithmetic. With --cases and no -o only the sweep of random cases near "
        "failure is made; it exits with 1 if an answer is wrong with status ok or a good pose is rejected. "
        "Needs a compiler with __float128. The families take about two minutes, a million cases another.",
    )
    _output(verb, "DIR", "folder to write to", "stability")
    verb.add_argument(
        "--cases", metavar="N", type=_whole, help=f"random cases near failure; with -o {ATLAS_CASES:,}"
    )
    verb.add_argument("--seed", type=_whole, default=0, help="of the random cases; default: 0")
    verb.add_argument(
        "--no-pictures", dest="pictures", action="store_false", help="tables only, without Matplotlib"
    )
    return parser


def _verb(
    verbs: "argparse._SubParsersAction[_Parser]",
    name: str,
    run: Callable[[argparse.Namespace], int],
    what: str,
    example: str,
    more: str = "",
) -> argparse.ArgumentParser:
    description = f"{what[0].upper()}{what[1:]}. {more}".strip()
    verb = verbs.add_parser(name, help=what, description=description, epilog=f"Example: {example}")
    verb.set_defaults(run=run, subcommand=name)
    return verb


def _robot(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("robot", metavar="ROBOT.toml", type=Path, help="robot file, schema 1")


def _output(verb: argparse.ArgumentParser, metavar: str, what: str, default: Path | str | None) -> None:
    """``default``: a path, words for what happens without the option, or None where it must be given."""
    text = what if default is None else f"{what}; default: {default}"
    path = default if isinstance(default, Path) else None
    verb.add_argument(
        "-o", "--output", metavar=metavar, type=_path, required=default is None, default=path, help=text
    )
    if metavar == "DIR":
        _force(verb)


def _force(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("--force", action="store_true", help="replace edited files and others' files")


def _path(text: str) -> Path:
    if not text.strip():
        raise argparse.ArgumentTypeError("expected a name, got nothing")
    return Path(text)


def _finite(text: str) -> float:
    with contextlib.suppress(ValueError):
        number = float(text)
        if math.isfinite(number):
            return number
    raise argparse.ArgumentTypeError(f"expected a finite number, got {text!r}")


def _positive(text: str) -> float:
    number = _finite(text)
    if number <= 0.0:
        raise argparse.ArgumentTypeError(f"expected a number > 0, got {text!r}")
    return number


def _whole(text: str) -> int:
    with contextlib.suppress(ValueError):
        number = int(text)
        if number >= 0:
            return number
    raise argparse.ArgumentTypeError(f"expected a whole number >= 0, got {text!r}")


def _start(verb: argparse.ArgumentParser) -> None:
    verb.add_argument(
        "--start",
        nargs=6,
        type=_finite,
        metavar=("t_x", "t_y", "t_z", "theta_x", "theta_y", "theta_z"),
        help="pose near the first leg lengths, m and rad; default: above the base, about parallel to it",
    )


def _log(verb: argparse.ArgumentParser) -> None:
    """Options of how a trajectory's file is read."""
    group = _log_form(verb)
    group.add_argument("--rate", type=_positive, metavar="HZ", help="resample; default: the log's own times")
    group.add_argument(
        "--noise-position",
        type=_positive,
        metavar="M",
        help="deviation of positions or lengths, m; default: found",
    )
    group.add_argument(
        "--noise-angle", type=_positive, metavar="RAD", help="deviation of angles, rad; default: found"
    )
    group.add_argument(
        "--cutoff",
        type=_positive,
        metavar="HZ",
        help="halve the amplitude there; default: the likeliest",
    )
    group.add_argument(
        "--no-smoothing", dest="smoothing", action="store_false", help="interpolate, whatever the noise"
    )


def _log_form(verb: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Options of names, units and marks in a trajectory's file."""
    group = verb.add_argument_group("the trajectory's file")
    group.add_argument(
        "--columns",
        type=_names,
        default={},
        metavar="NAME=HEADER,...",
        help="which header stands for time, t_x, ...; all other columns are skipped",
    )
    for name, choices in (
        ("length-unit", ("m", "cm", "mm", "in")),
        ("angle-unit", ("rad", "deg")),
        ("time-unit", ("s", "ms", "us")),
    ):
        group.add_argument(f"--{name}", choices=choices, default=choices[0], help=f"default: {choices[0]}")
    group.add_argument("--delimiter", choices=("comma", "semicolon", "tab"), help="default: detected")
    group.add_argument("--decimal", choices=("point", "comma"), help="default: detected")
    group.add_argument(
        "--euler-order",
        choices=("xyz", "xzy", "yxz", "yzx", "zxy", "zyx"),
        default="zyx",
        help="of the rotations multiplied; default: zyx, R = Rz Ry Rx",
    )
    return group


def _names(text: str) -> dict[str, str]:
    pairs = [pair.partition("=") for pair in text.split(",")]
    names = {name.strip(): given.strip() for name, _, given in pairs}
    if not all(sign and name.strip() and given.strip() for name, sign, given in pairs) or len(names) < len(
        pairs
    ):
        raise argparse.ArgumentTypeError(f"expected NAME=HEADER,NAME=HEADER,..., got {text!r}")
    return names


def _formulation(verb: argparse.ArgumentParser) -> None:
    verb.add_argument(
        "--formulation",
        choices=("exact", "paper"),
        default="exact",
        help="exact, or paper: the equations as printed; default: exact",
    )


if __name__ == "__main__":
    sys.exit(main())
