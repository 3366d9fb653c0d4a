"""A fuzzer of the readers of files:  python tests/support/fuzz_files.py -runs=20000 -seed=1 FOLDER

Bytes become a file that Robot.from_toml, read_scene and the readers of CSV get to read; the first byte says
which. Any of them must read it or reject it by a ValueError of one line that begins with the file's name.
FOLDER holds the files to start from and takes those that reach new code. Needs Atheris.
"""

import sys
import tempfile
import warnings
from pathlib import Path

import atheris

READ = ["tomllib", "stewart_sym.io.toml_reader"]
READ += [f"stewart_sym.robot.{name}" for name in ("robot", "schema_2", "bodies", "points")]
with atheris.instrument_imports(include=READ):
    import stewart_sym.robot.robot
with atheris.instrument_imports(include=["stewart_sym.simulation.scene", "stewart_sym.motion.trajectory"]):
    from plain_logs import read_log

    from stewart_sym.motion import log_samples
    from stewart_sym.simulation import scene

READERS = (
    stewart_sym.robot.robot.Robot.from_toml,
    scene.read_scene,
    read_log,
    lambda path: log_samples.read_samples(str(path), forces=True),
)
LONGEST = 1000


def check(path: Path, data: bytes) -> None:
    """Let the reader that the first byte names read the other bytes."""
    path.write_bytes(data[1:])
    try:
        found = READERS[data[0] % len(READERS)](path)
    except ValueError as error:
        text = str(error)
        # What is wrong in a file that a scene names is blamed on that file.
        assert text.startswith(str(path.parent)), text
        assert text.isprintable(), text
        assert len(text) - len(str(path)) < LONGEST, text
        return
    if isinstance(found, stewart_sym.robot.robot.Robot):
        again = stewart_sym.robot.robot.Robot.from_dict(found.to_dict())
        assert again.to_dict() == found.to_dict()


def main() -> None:
    """Fuzz as the command line says."""
    warnings.simplefilter("ignore")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "file"

        def one(data: bytes) -> None:
            check(path, data or b"\0")

        atheris.Setup(sys.argv, one)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
