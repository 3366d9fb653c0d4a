"""Kernels that are derived at first use have the committed digests, whatever the cache folder contains."""

import hashlib
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from sweeps import FULL, slow_but

from stewart_sym.backend import kernel, native
from stewart_sym.backend.kernel import digests, generated_text
from stewart_sym.calls import c_kernel
from stewart_sym.derive.on_demand import ON_DEMAND, kernel_files

SHORT = "stewart_exact_massless_static_forces"
SOURCE = f"c/{SHORT}.c"
KINDS = (
    SHORT,
    "stewart_paper_spherical",
    "exact_spherical",
    "exact_offset_arrays",
    "stewart_exact_drive_bounds",
)


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty cache folder that does not exist yet; nothing of it is in memory."""
    folder = tmp_path / "cache"
    monkeypatch.setenv("STEWART_SYM_CACHE", str(folder))
    kernel._derived.cache_clear()
    yield folder
    kernel._derived.cache_clear()


def digest(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


@pytest.mark.parametrize("name", slow_but([SHORT], ON_DEMAND if FULL else KINDS))
def test_a_kernel_derived_alone_has_the_digests_of_the_table(name: str) -> None:
    texts = kernel_files(name)
    assert {path: digest(text) for path, text in texts.items()}.items() <= digests().items()


def test_the_table_lists_the_files_of_all_kernels_on_demand_and_of_no_other() -> None:
    assert {Path(path).stem for path in digests()} == ON_DEMAND.keys()
    package = Path(kernel.__file__).parents[2] / "generated"
    assert not [path for path in digests() if (package / path).exists()]


def test_a_kernel_is_derived_once_and_then_read_without_sympy(cache: Path) -> None:
    text = generated_text(SOURCE)
    header = SOURCE.replace(".c", ".h")
    assert {path: digest(generated_text(path)) for path in (SOURCE, header)}.items() <= digests().items()
    code = f"""
import sys
sys.modules["sympy"] = None
from stewart_sym.backend.kernel import generated_text
assert generated_text({SOURCE!r}) == sys.stdin.read()
assert generated_text({header!r})
"""
    subprocess.run([sys.executable, "-c", code], input=text.encode(), check=True)


def test_without_a_cache_folder_a_kernel_is_derived(cache: Path) -> None:
    cache.write_text("a file in place of the folder")
    assert digest(generated_text(SOURCE)) == digests()[SOURCE]
    assert cache.is_file()


def test_without_a_compiler_one_line_names_it(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(native, "find_compiler", lambda: None)
    with pytest.raises(native.CompilerError, match=r"^no C compiler found; install gcc or clang, .*$"):
        c_kernel.library.__wrapped__("exact_massless_static_forces")


def test_a_text_with_another_digest_is_rejected(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(ON_DEMAND, SHORT, lambda version: type("Result", (), {"files": {SOURCE: "int x;\n"}}))
    with pytest.raises(ImportError, match=f"^kernel {SHORT}: {SOURCE} differs from its digest"):
        generated_text(SOURCE)


def test_processes_and_threads_may_derive_a_kernel_at_the_same_time(cache: Path) -> None:
    code = f"from stewart_sym.backend.kernel import generated_text as f; print(f({SOURCE!r}), end='')"
    others = [subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE) for _ in range(2)]
    texts: list[str] = []
    threads = [threading.Thread(target=lambda: texts.append(generated_text(SOURCE))) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    texts += [process.communicate()[0].decode() for process in others]
    assert {digest(text) for text in texts} == {digests()[SOURCE]}
    assert len(texts) == 4
    assert {path.suffix for path in cache.iterdir()} == {".c", ".lock"}


def test_a_derived_module_is_imported_under_its_name_in_the_package() -> None:
    from stewart_sym.generated import exact_spherical

    assert exact_spherical.__name__ == "stewart_sym.generated.exact_spherical"
    assert sum(exact_spherical.OPERATIONS["friction"]["total"]) > 1000
