"""The site builds without a warning, loads nothing from a network, and every local link leads somewhere."""

import re
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from browser import chromium
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
WIDTHS = (390, 768, 1024, 1366, 1440)
"""Widths of windows (pixels) in which pages are tested."""
EXCESS = """async ([addresses, widths]) => {
    const wide = {};
    const measure = async (address) => {
        const frame = document.createElement("iframe");
        // Without scripts, which a layout does not need, and never drawn.
        frame.setAttribute("sandbox", "allow-same-origin");
        frame.style = "visibility: hidden; height: 900px";
        const loaded = new Promise((done) => frame.addEventListener("load", done));
        frame.src = address;
        document.body.append(frame);
        await loaded;
        const inner = frame.contentDocument;
        const isWide = (width) => {
            frame.style.width = `${width}px`;
            return [inner.documentElement, inner.querySelector(".content")]
                .some((element) => element && element.scrollWidth > element.clientWidth);
        };
        const found = widths.filter(isWide);
        if (found.length) wide[address] = found;
        frame.remove();
    };
    const worker = async () => { while (addresses.length) await measure(addresses.pop()); };
    await Promise.all([1, 2, 3, 4].map(worker));
    return wide;
}"""
"""Widths at which pages are wider than their window, by page: one load each, in frames that are not drawn."""
IS_SORTED = """() => {
    const heading = document.querySelector("#search-results h2");
    return heading && !heading.textContent.includes("Searching");
}"""
"""Whether the search has ended: results are then in their order."""
SEARCHES = {
    "Jacobian": ("theory/kinematics.html", "reference/python/kinematics.html"),
    "inverse Jacobian": ("theory/kinematics.html", "reference/python/kinematics.html"),
    "mass matrix": ("theory/equations-of-motion.html",),
    "direct kinematics": ("theory/kinematics.html",),
    "install": ("installation.html",),
    "troubleshoot": ("troubleshooting.html",),
}
"""Pages of which one is to be the first result, by query."""


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


def wide_pages(pages: Iterable[Path], widths: tuple[int, ...] = WIDTHS) -> dict[str, list[int]]:
    """Return the widths of windows (pixels) in which pages scroll sideways, by page."""
    with chromium("--allow-file-access-from-files") as browser:
        page = browser.new_page()
        page.goto((DOCS / "static" / "wide.css").as_uri())
        addresses = [path.as_uri() for path in pages]
        found: dict[str, list[int]] = page.evaluate(EXCESS, [addresses, list(widths)])
    return {Path(address).name: wide for address, wide in found.items()}


@pytest.mark.slow
def test_no_page_scrolls_sideways(site: Path) -> None:
    pages = [path for path in site.rglob("*.html") if "_static" not in path.parts]
    assert len(pages) > len(PAGES)
    assert wide_pages([site / "index.html"], widths=(60,)) == {"index.html": [60]}
    assert wide_pages(pages) == {}


@pytest.mark.slow
def test_the_search_of_the_site_finds_the_right_page_first(site: Path) -> None:
    with chromium("--allow-file-access-from-files") as browser:
        page = browser.new_page()
        for query, expected in SEARCHES.items():
            page.goto(f"{(site / 'search.html').as_uri()}?q={query.replace(' ', '+')}")
            page.wait_for_selector("#search-results li > a")
            page.wait_for_function(IS_SORTED)
            first = page.query_selector("#search-results li > a")
            assert first is not None
            assert (first.get_attribute("href") or "").split("#")[0] in expected, query


@pytest.mark.slow
def test_every_public_name_has_one_entry(site: Path) -> None:
    pages = (site / "reference" / "python").glob("*.html")
    entries = [name for page in pages for name in ENTRY.findall(page.read_text(encoding="utf-8"))]
    assert sorted(entries) == sorted(set(ss.__all__) - {"results", "robots"})
