"""Exceptions that are raised where something is wrong.

Every exception of Girth has a ``code`` of one table (`error_codes`), the first offending
``element``, and a ``hint``: what to do about it.
"""

from __future__ import annotations

import errno
import sys

from pygirth import _girth

__all__ = [
    "GirthError",
    "InputError",
    "LimitError",
    "MissingFileError",
    "MissingPackageError",
    "error_codes",
]

#: The code of every error: (exit code of the command, general remedy).
error_codes: dict[str, tuple[int, str]] = _girth.error_codes


class GirthError(Exception):
    """Something is wrong, and what to do about it.

    Attributes
    ----------
    code : str
        Such as ``"INDEX_OUT_OF_RANGE"``; the table is `error_codes`.
    element : int
        The first offending vertex, face, line or byte, as the message states; -1: none.
    message : str
        The fault, and where it is.
    hint : str
        The remedy; may be empty.
    file : str
        The file that it is about; empty where no path was given.
    """

    def __init__(
        self, code: str, message: str, hint: str = "", element: int = -1, file: str = ""
    ) -> None:
        super().__init__(code, message, hint, element, file)
        self.code = code
        self.message = message
        self.hint = hint
        self.element = element
        self.file = file

    def __str__(self) -> str:
        text = f"{self.code}: {self.message}"
        if self.file:
            text = f"{self.file}: {text}"
        return f"{text}; {self.hint}" if self.hint else text


class InputError(GirthError, ValueError):
    """An argument or a file is wrong."""


class MissingFileError(InputError, FileNotFoundError):
    """There is no file at a path.

    Attributes
    ----------
    errno, strerror, filename
        As of every `FileNotFoundError`.
    """

    def __init__(
        self, code: str, message: str, hint: str = "", element: int = -1, file: str = ""
    ) -> None:
        super().__init__(code, message, hint, element, file)
        self.errno = errno.ENOENT
        self.strerror = message
        self.filename = file


class LimitError(GirthError, RuntimeError):
    """A limit was met: of memory, of size, or of the program itself."""


class MissingPackageError(GirthError, ModuleNotFoundError):
    """Something is asked for that needs another package, which is not installed.

    Attributes
    ----------
    name : str
        The name of the package.
    """

    @classmethod
    def of(cls, package: str, purpose: str) -> "MissingPackageError":
        """The error where `purpose` needs a package that there is not."""
        error = cls(
            "PROGRAM_NOT_LOADED",
            f"{purpose} needs {package}, which this Python ({sys.executable}) does not have",
            f"install it: python -m pip install {package.lower()}",
        )
        error.name = package.lower()
        return error


def exception_of(
    code: str, exit_code: int, element: int, message: str, hint: str, file: str
) -> GirthError:
    """The exception that stands for an error of the core."""
    if code == "FILE_NOT_FOUND":
        return MissingFileError(code, message, hint, element, file)
    kind = LimitError if exit_code == 3 else InputError
    return kind(code, message, hint, element, file)


def input_error(code: str, message: str, hint: str = "", element: int = -1) -> InputError:
    """An error of an argument; the hint is by default the general one of its code."""
    return InputError(code, message, hint or error_codes[code][1], element)
