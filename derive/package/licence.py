"""The terms under which generated code may be used: free of any condition."""

from .words import template

SPDX = "0BSD"
"""As every generated file says it, by SPDX's list of licences."""

SAYS = "Generated code: use, change and pass it on without any condition; no warranty (SPDX: 0BSD)."

TEXT = template("kit/LICENSE")
