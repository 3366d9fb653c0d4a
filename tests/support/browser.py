"""Pages in Debian's Chromium, without a screen: pixels as arrays, and the eye's projection in NumPy."""

import io
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import matplotlib.image
import numpy as np
from numpy.typing import NDArray
from playwright.sync_api import Browser, Page, sync_playwright

Array = NDArray[np.float64]

ARGUMENTS = (
    *("--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking"),
    *("--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader"),
    *("--enable-unsafe-swiftshader", "--force-color-profile=srgb", "--hide-scrollbars"),
)
DOTS = 2
"""Dots of a pixel in either direction, so that ends are found to less than one."""
FIELD = np.radians(32.0)
"""Angle of view, of the smaller side of a picture."""
COLORS = np.array(
    [
        [*bytes.fromhex(each)]
        for each in ("2166ac", "67a9cf", "d1e5f0", "f7f7f7", "fddbc7", "ef8a62", "b2182b")
    ]
)
"""Colors of forces from -scale to scale, at even steps."""


@contextmanager
def chromium(*arguments: str) -> Iterator[Browser]:
    """Start the browser that Debian has, with more arguments."""
    with sync_playwright() as playwright:
        path = shutil.which("chromium")
        assert path is not None, "expected Debian's package chromium"
        browser = playwright.chromium.launch(executable_path=path, args=[*ARGUMENTS, *arguments])
        yield browser
        browser.close()


class Opened:
    """A page that was opened from a file, with all that it said and asked for."""

    def __init__(
        self, browser: Browser, path: Path, size: tuple[int, int] = (560, 520), **options: Any
    ) -> None:
        """Open it at rest: nothing moves before the test moves it."""
        window = {"width": size[0], "height": size[1]}
        options = {"reduced_motion": "reduce", "viewport": window, "device_scale_factor": DOTS} | options
        self.context = browser.new_context(**options)
        self.page: Page = self.context.new_page()
        self.said: list[str] = []
        self.requests: list[str] = []
        self.page.on("console", lambda message: self.said.append(message.text))
        self.page.on("pageerror", lambda error: self.said.append(str(error)))
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.goto(path.as_uri())
        self.page.wait_for_function("() => document.readyState === 'complete'")
        self.settle()

    def do(self, script: str) -> Any:
        """What a function of the page returns."""
        return self.page.evaluate(f"() => {{ {script} }}")

    def settle(self) -> None:
        """Wait until what changed is drawn."""
        self.do("return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def drawn(self) -> NDArray[np.int64]:
        """Dots of the machine's picture, (height, width, 3), 0 to 255, once what changed is drawn."""
        self.settle()
        # The browser puts a canvas on whole dots; a picture of the canvas alone would be cut on whole pixels.
        box = self.do(
            "const { x, y, width, height } = scene.getBoundingClientRect(); return [x, y, width, height]"
        )
        x, y, width, height = np.rint(DOTS * np.array(box)).astype(int)
        found: Array = matplotlib.image.imread(io.BytesIO(self.page.screenshot()))
        return np.rint(255.0 * found[y : y + height, x : x + width, :3]).astype(np.int64)

    def close(self) -> None:
        """Close it."""
        self.context.close()


def color(force: float, scale: float) -> Array:
    """Color of a force, 0 to 255, (3,)."""
    at = (np.clip(force / scale, -1.0, 1.0) + 1.0) * 3.0
    return np.array([np.interp(at, np.arange(7), column) for column in COLORS.T])


def pixels(points: Array, camera: dict[str, Any], picture: dict[str, float]) -> Array:
    """Pixels (n, 2) at which points (n, 3) are seen: a pinhole at the eye that looks at the target."""
    eye, target, up = (np.array(camera[name]) for name in ("eye", "target", "up"))
    ahead = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(ahead, up)
    right /= np.linalg.norm(right)
    seen = (points - eye) @ np.stack([right, np.cross(right, ahead), ahead], axis=-1)
    focus = 0.5 * min(picture["width"], picture["height"]) / np.tan(0.5 * FIELD)
    flat = focus * seen[:, :2] / seen[:, 2:]
    middle = [picture["x"] + 0.5 * picture["width"], picture["y"] + 0.5 * picture["height"]]
    return np.asarray(middle + flat * [1.0, -1.0])
