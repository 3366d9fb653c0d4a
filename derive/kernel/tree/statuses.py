"""What kernels return: the status codes of every language."""

STATUS = (
    ("OK", 0, "solved"),
    ("NOT_FINITE", 1, "an input is not finite, or a result overflows"),
    ("ZERO_LENGTH", 2, "a leg has length zero"),
    ("JOINT_SINGULAR", 3, "a leg lies along the fixed axis of its universal joint"),
    ("SINGULAR", 4, "H is singular: no leg forces can hold the platform"),
    ("BAD_ARGUMENT", 5, "a pointer that must not be null is null"),
    ("INDEFINITE", 6, "the inertia matrix M is not positive definite: no body has such inertias"),
    ("NOT_CONVERGED", 7, "no pose with these leg lengths was found"),
)
"""Name, code and meaning of each status."""
