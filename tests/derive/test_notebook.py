"""The notebooks of the derivation run from start to end, and show what the code gives now.

``COMMAND`` runs them and writes the outputs into the committed files.
"""

import os
import subprocess
import sys
from importlib import resources
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from installed import installed
from quick_compiler import quick_path
from sweeps import FULL

from stewart_sym.io.error_policy import EXTRAS

FOLDER = resources.files("stewart_sym.derive")
NOTEBOOKS = ("derivation", "closed_form", "evidence")
COMMAND = "PYTHONPATH=tests/support:tests/support/kernels python tests/derive/test_notebook.py"
REWRITE = f"run `{COMMAND}` and look at the notebooks"
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}
WITHOUT = """
import sys

class Missing:
    def find_spec(self, name, path=None, target=None):
        if name in {names}:
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)

sys.meta_path.insert(0, Missing())
"""


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_cell_is_committed_as_executed_in_order_without_error(name: str) -> None:
    cells = _code_cells(_committed(name))
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [out for cell in cells for out in cell.outputs if _is_unwanted(out)]


@pytest.mark.slow
@pytest.mark.parametrize("name", NOTEBOOKS if FULL else NOTEBOOKS[:1])
def test_a_plain_install_runs_it_with_its_extra_and_gives_the_committed_outputs(
    name: str, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In a folder of its own, and without the packages of other extras."""
    package = installed(tmp_path_factory)
    others = set(EXTRAS) - {"matplotlib", "mpl_toolkits"}
    (tmp_path / "without").mkdir()
    (tmp_path / "without" / "sitecustomize.py").write_text(WITHOUT.format(names=others))
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(tmp_path / "without"), str(package)]))
    monkeypatch.setenv("PATH", quick_path(tmp_path / "compilers"))
    for variable in ("IPYTHONDIR", "JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR"):
        monkeypatch.setenv(variable, str(tmp_path / variable))
    used = subprocess.run(
        [sys.executable, "-c", "import stewart_sym; print(stewart_sym.__file__)"],
        check=True,
        capture_output=True,
        text=True,
        cwd=tmp_path,
    )
    assert Path(used.stdout.strip()).is_relative_to(package)
    committed = _code_cells(_committed(name))
    fresh = _code_cells(_executed(name, tmp_path))
    assert not [out for cell in fresh for out in cell.outputs if out.output_type == "error"]
    for was, now in zip(committed, fresh, strict=True):
        assert _shown(now) == _shown(was), f"cell {was.id} shows something else: {REWRITE}"


def _committed(name: str) -> Any:
    import nbformat

    return nbformat.reads((FOLDER / f"{name}.ipynb").read_text("utf-8"), as_version=4)  # type: ignore[no-untyped-call]


def _executed(name: str, folder: Path) -> Any:
    """The notebook after a run in ``folder``; CellExecutionError when a cell fails."""
    from nbclient import NotebookClient

    notebook = _committed(name)
    client = NotebookClient(
        notebook,
        timeout=3600,
        kernel_name="python3",
        record_timing=False,
        resources={"metadata": {"path": str(folder)}},
    )
    client.execute()
    return notebook


def _code_cells(notebook: Any) -> list[Any]:
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def _is_unwanted(output: Any) -> bool:
    """Whether it is an error or something that was written to stderr, such as a warning."""
    return bool(output.output_type == "error" or output.get("name") == "stderr")


def _shown(cell: Any) -> list[dict[str, str]]:
    """What a cell prints and shows, but for pictures: their bytes depend on Matplotlib's version."""
    return [
        {"text/plain": output.text}
        if output.output_type == "stream"
        else {kind: text for kind, text in output.data.items() if not kind.startswith("image/")}
        for output in cell.outputs
        if not _is_unwanted(output)
    ]


def _rewrite(name: str) -> None:
    import nbformat

    with TemporaryDirectory() as folder:
        notebook = _executed(name, Path(folder))
    notebook.metadata = METADATA
    nbformat.write(notebook, str(FOLDER / f"{name}.ipynb"))  # type: ignore[no-untyped-call]


if __name__ == "__main__":
    for chosen in sys.argv[1:] or NOTEBOOKS:
        _rewrite(chosen)
