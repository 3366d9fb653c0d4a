"""License of generated code: use without any condition."""

from .text_format import template

NOTICE = "Generated code: use, change, and pass it on without any condition; no warranty (SPDX: 0BSD)."

TEXT = template("kit/LICENSE")
