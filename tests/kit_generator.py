"""``stewart-sym generate`` as a build sees it, with the build files: for builds of kits in the tests.

Writes kernels of functions ``forces`` and ``motion`` with the robot's constants, programs and build files,
and keeps to the rule about files that were edited. Used as a program: generate ROBOT -o DIR [options].
"""

import argparse
import dataclasses
import hashlib
import json
import sys
from importlib.metadata import version
from pathlib import Path

from stewart_sym import kernel
from stewart_sym.derive.emit import kit_build
from stewart_sym.derive.emit.kit import robot_symbol
from stewart_sym.kit import Choice, kit
from stewart_sym.robot import Robot

MANIFEST = "manifest.json"


def texts(robot: Robot, functions: tuple[str, ...], precision: str = "double") -> dict[str, str]:
    """File name -> text."""
    files = dict(kit(robot, Choice(fidelity="general", precision=precision)).files)
    files["main.c"] = files["selftest.c"] = files.pop("example.c").replace("example.c", "main.c")
    if "motion" in functions:
        motion = kernel.c_sources("exact_motion")
        files |= {name: text for name, text in motion.items() if name.startswith("stewart_exact_motion")}
    package = kit_build.Package(
        robot_symbol(robot.name),
        version("stewart-sym"),
        tuple(name for name in sorted(files) if name.endswith(".c") and name not in ("main.c", "selftest.c")),
        tuple(name for name in sorted(files) if name.endswith(".h")),
        precision,
    )
    return files | {
        "CMakeLists.txt": kit_build.cmake_lists(package),
        kit_build.CONFIG_IN: kit_build.config_in(package),
        "Makefile": kit_build.makefile(package),
    }


def renamed(robot: Robot, name: str) -> Robot:
    """The same machine by another name."""
    return dataclasses.replace(robot, name=name)


def write(files: dict[str, str], directory: Path) -> None:
    """Replace what differs; ValueError for a file that is neither as written last nor as it is to be."""
    directory.mkdir(parents=True, exist_ok=True)
    manifest = directory / MANIFEST
    known = json.loads(manifest.read_text(encoding="utf-8")) if manifest.exists() else {}
    changed = {}
    for name, text in files.items():
        path = directory / name
        found = path.read_text(encoding="utf-8") if path.exists() else None
        if found is not None and text != found and digest(found) != known.get(name):
            raise ValueError(f"{path}: exists with other content; use --force to overwrite")
        if text != found:
            changed[name] = text
    for name, text in changed.items():
        (directory / name).write_text(text, encoding="utf-8")
    digests = {name: digest(text) for name, text in files.items()}
    if digests != known:
        manifest.write_text(json.dumps(digests), encoding="utf-8")


def digest(text: str) -> str:
    """SHA-256, hexadecimal."""
    return hashlib.sha256(text.encode()).hexdigest()


def main() -> int:
    """Run the verb; 2 and a line on standard error if it fails."""
    parser = argparse.ArgumentParser()
    parser.add_argument("verb", choices=["generate"])
    parser.add_argument("robot", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--functions", default="forces")
    parser.add_argument("--precision", default="double")
    arguments = parser.parse_args()
    try:
        robot = Robot.from_toml(arguments.robot)
        files = texts(robot, tuple(arguments.functions.split(",")), arguments.precision)
        write(files, arguments.output)
    except (ValueError, OSError) as error:
        print(f"stewart-sym: error: {error}", file=sys.stderr)
        return 2
    for name in files:
        print(arguments.output / name)
    print("operations of a pose: some")
    return 0


if __name__ == "__main__":
    sys.exit(main())
