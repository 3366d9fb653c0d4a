"""The site builds without a warning, loads nothing from a network, and every local link leads somewhere."""

import re
import subprocess
import sys
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from pages import DOCS, PAGES, TOP, anchors, links, pictures

import stewart_sym as ss

LOADED = re.compile(
    r'<(?:script|img|iframe|link|source|video)\b[^>]*?\b(?:src|href)="(https?:|//)', re.IGNORECASE
)
ENTRY = re.compile(r'<dt class="sig[^>]* id="stewart_sym\.(\w+)"')
BUILD = (
    "import socket, sys\n"
    "def unreachable(*_, **__): raise OSError('no network')\n"
    "socket.socket.connect = socket.create_connection = socket.getaddrinfo = unreachable\n"
    "from sphinx.cmd.build import main\n"
    "sys.exit(main(sys.argv[1:]))"
)


@pytest.mark.parametrize("page", PAGES)
def test_local_links_lead_to_files_and_headings(page: str) -> None:
    for target in links(page):
        parts = urlsplit(target)
        assert not parts.scheme, target
        path = (TOP / page).parent / parts.path if parts.path else TOP / page
        assert path.exists(), target
        assert not parts.fragment or parts.fragment in anchors(path), target
    assert all(path.exists() for path in pictures(page))


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site, built with warnings as errors and without a network."""
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-c", BUILD, "-q", "-W", "--keep-going", "-b", "html", str(DOCS), str(folder)]
    done = subprocess.run([*command, "-d", str(folder / ".doctrees")], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.mark.slow
def test_the_site_has_every_page_and_loads_nothing_from_elsewhere(site: Path) -> None:
    for page in PAGES[1:]:
        html = site / Path(page).relative_to(".docs").with_suffix(".html")
        assert not LOADED.findall(html.read_text(encoding="utf-8")), page
    sheets = "".join(path.read_text(encoding="utf-8") for path in site.rglob("*.css"))
    assert not re.findall(r"(?:url\(|@import\s*)['\"]?(?:https?:)?//", sheets)


@pytest.mark.slow
def test_every_public_name_has_one_entry(site: Path) -> None:
    pages = (site / "reference" / "python").glob("*.html")
    entries = [name for page in pages for name in ENTRY.findall(page.read_text(encoding="utf-8"))]
    assert sorted(entries) == sorted(set(ss.__all__) - {"results", "robots"})
