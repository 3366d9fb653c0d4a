"""What becomes of a fault: schedules with early return, and poses side by side that carry a status on."""


def returned(holds, code) -> None:
    """The function ends."""
    if not holds:
        return code


def carried(holds, code) -> None:
    """The first fault stays."""
    status = where((status != OK) | (holds), status, code)
