"""Prints how fast the viewer loads and draws 60,000 instants, in three sizes of a window.

Run with PYTHONPATH=tests/support:tests/support/robots. The time to the first picture counts from the start of
loading; frames are those of five seconds of play.
"""

import tempfile
from pathlib import Path

import numpy as np
from browser import Opened, chromium
from machines import dasgupta
from playwright.sync_api import Browser

import stewart_sym as ss

SIZES = {"phone": (390, 844), "laptop": (1280, 800), "wide": (1920, 1080)}
FIRST = """
    return new Promise((done) => {
      const seen = () => {
        if (viewer.seen.frames > 1) done(performance.now());
        else requestAnimationFrame(seen);
      };
      seen();
    })
"""
FRAMES = """
    viewer.clock.play();
    return new Promise((done) => {
      setTimeout(() => {
        const [frames, start] = [viewer.seen.frames, performance.now()];
        setTimeout(() => done((1e3 * (viewer.seen.frames - frames)) / (performance.now() - start)), 5000);
      }, 2000);
    })
"""


def measure(browser: Browser, path: Path, size: tuple[int, int]) -> tuple[float, float]:
    """Seconds until the machine is drawn, and frames a second."""
    page = Opened(browser, path, size, reduced_motion="no-preference", device_scale_factor=1)
    first, frames = page.do(FIRST), page.do(FRAMES)
    page.close()
    return 1e-3 * first, frames


def main() -> None:
    """Three rounds of each size, of which the medians count."""
    path, _ = ss.PATHS["I"]
    time = np.linspace(0.0, path.tau_f, 60_000)
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        file = Path(folder) / "long.html"
        ss.view(dasgupta(), path.sample(time), time).save(file)
        for name, size in SIZES.items():
            found = np.median([measure(browser, file, size) for _ in range(3)], axis=0)
            print(f"{name:6} {size[0]:4} x {size[1]:4}: {found[0]:.2f} s, {found[1]:.1f} frames a second")


if __name__ == "__main__":
    main()
