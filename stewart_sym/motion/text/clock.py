"""Dates and times of day in a log as seconds since its first row."""

import datetime

READ = "dates as 2026-11-26 10:00:00.125 (ISO 8601) and times of day as 10:00:00.125 are read as times"
"""What is read, in words."""
_DATE, _ZONED, _DAY = "a date and time", "a date and time with a zone", "a time of day"
_SECOND, _DIGITS = 10**9, 9


class Clock:
    """Seconds since the first of the texts that it is given: the nearest doubles of what is written."""

    def __init__(self) -> None:
        self._kind, self._start, self._last, self._text = "", 0, 0, ""

    def seconds(self, text: str, where: str) -> float:
        """Seconds of a row's cell; ValueError where it is of another kind than the first or goes back."""
        kind, time = instant(text) or ("", 0)
        if not self._kind:
            self._kind, self._start, self._last = kind, time, time
        if kind != self._kind or not kind:
            raise ValueError(f"{where}: expected {self._kind} as in the first row, got {text[:40]!r}: {READ}")
        if time < self._last:
            hint = ": past midnight dates are needed too" if kind == _DAY else ""
            raise ValueError(f"{where}: expected increasing times, got {text} after {self._text}{hint}")
        self._last, self._text = time, text
        return (time - self._start) / _SECOND


def instant(text: str) -> tuple[str, int] | None:
    """Kind and ns since 1970 or midnight of a date and time (ISO 8601) or a time of day; None of others."""
    whole, mark, rest = text.replace(",", ".").partition(".")
    zone = rest.lstrip("0123456789")
    digits = rest.removesuffix(zone)
    if ":" not in whole or len(digits) > _DIGITS or bool(mark) != bool(digits):
        return None
    part = int(digits.ljust(_DIGITS, "0"))
    try:
        if "-" not in whole:
            of_day = datetime.time.fromisoformat("0" * (whole[1:2] == ":") + whole + zone)
            return _DAY, (3600 * of_day.hour + 60 * of_day.minute + of_day.second) * _SECOND + part
        found = datetime.datetime.fromisoformat(whole + zone)
    except ValueError:
        return None
    start = datetime.datetime(1970, 1, 1, tzinfo=None if found.tzinfo is None else datetime.UTC)
    kind = _DATE if found.tzinfo is None else _ZONED
    return kind, (found - start) // datetime.timedelta(seconds=1) * _SECOND + part
