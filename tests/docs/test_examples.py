"""Every example of the README and of the documentation runs and gives what the page says."""

from collections.abc import Iterator
from pathlib import Path

import matplotlib.image
import pytest
from cost_figures import hasty
from draw_all import DRAWINGS
from drawing_sheet import save
from pages import (
    DOCS,
    PAGES,
    blocks,
    pictures,
    prepared,
    run_page,
    same_picture,
    text_of,
)
from sweeps import FULL, slow_but

import stewart_sym as ss

_HEAVY = ("gallery/mpc", "gallery/computed-torque", "gallery/controller-models")
_HEAVY += ("howto/plan", "howto/languages", "howto/cmake", "howto/simulate", "howto/drives", "howto/fidelity")
_HEAVY += ("gallery/motors", "gallery/telemetry", "howto/workspace")
HEAVY = set() if FULL else {f".docs/{name}.md" for name in _HEAVY}
"""Pages whose examples take five seconds and more, but those of tutorials, README and kits."""
RUNNING = [
    page
    for page in PAGES
    if page not in HEAVY and any(block.language in ("python", "sh") for block in blocks(page))
]
SHELL = {page for page in RUNNING if any(block.language == "sh" for block in blocks(page))}
LONG = {
    f".docs/gallery/{name}.md"
    for name in ("mpc", "computed-torque", "controller-models", "around-a-singularity")
} | {f".docs/howto/{name}.md" for name in ("arrays", "cluster", "controller", "friction")}
DARKEST_PAPER = 0.94
"""Brightness below which a dot of a drawing is ink, 0 to 1."""


@pytest.fixture(autouse=True, scope="module")
def same_robots() -> Iterator[None]:
    """One robot of all files with the same content, whose kits then share their test vectors."""
    read = ss.Robot.from_toml
    known: dict[bytes, ss.Robot] = {}

    def once(path: str | Path) -> ss.Robot:
        content = Path(path).read_bytes() if Path(path).is_file() else b""
        if content not in known:
            known[content] = read(path)
        return known[content]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(ss.Robot, "from_toml", once)
        yield


@pytest.mark.parametrize("page", slow_but(set(RUNNING) - SHELL - LONG, RUNNING))
def test_examples_run_in_order_and_give_what_the_page_says(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if "stewart-sym choose-fidelity" in text_of(page):
        hasty(monkeypatch)
    monkeypatch.chdir(prepared(page, tmp_path))
    run_page(page, tmp_path)
    for committed in pictures(page):
        for made in tmp_path.glob(f"**/*{committed.name}"):
            assert same_picture(made, committed), committed.name


@pytest.mark.slow
@pytest.mark.parametrize("name", DRAWINGS)
def test_drawings_are_those_of_their_scripts_and_not_cut_off(name: str, tmp_path: Path) -> None:
    save(DRAWINGS[name](), tmp_path / "drawing.png")
    assert same_picture(tmp_path / "drawing.png", DOCS / name)
    ink = matplotlib.image.imread(DOCS / name)[..., :3].min(axis=-1) < DARKEST_PAPER
    assert ink.mean() > 0.01
    assert not any(edge.any() for edge in (ink[:4], ink[-4:], ink[:, :4], ink[:, -4:]))
