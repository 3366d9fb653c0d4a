"""Long description for a package index: the README without its picture, whose path leads nowhere there."""

from pathlib import Path

from setuptools import setup

LINES = Path(__file__).with_name("README.md").read_text(encoding="utf-8").splitlines(keepends=True)

setup(
    long_description="".join(line for line in LINES if not line.startswith("![")),
    long_description_content_type="text/markdown",
)
