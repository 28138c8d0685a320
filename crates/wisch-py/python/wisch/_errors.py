"""The exception of wisch."""

from __future__ import annotations


class WischError(ValueError):
    """A file, a value, a motion or a sample of an executor is invalid.

    ``file`` is the file, ``place`` the line and column in it (from 1), ``value`` the given value, ``limit`` the allowed
    values, and ``help`` a remedy; each is None if unknown.
    """

    def __init__(
        self,
        message: str,
        file: str | None = None,
        place: tuple[int, int] | None = None,
        value: str | None = None,
        limit: str | None = None,
        help: str | None = None,
    ) -> None:
        super().__init__(message)
        self.file = file
        self.place = place
        self.value = value
        self.limit = limit
        self.help = help

    def __str__(self) -> str:
        message = super().__str__()
        return message if self.help is None else f"{message}\n  help: {self.help}"

    def __reduce__(self):
        parts = (self.args[0], self.file, self.place, self.value, self.limit, self.help)
        return type(self), parts
