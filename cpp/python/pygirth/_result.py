"""How results show themselves, and the older names of their members."""

import warnings
from typing import Any

#: Older names of members and arguments, until 2.0.
_OLDER = {"median_thickness": "median_shape_diameter", "thickness": "shape_diameter"}


def warn_of_older(name: str, *, above: int = 3) -> str:
    """Warns whoever calls from `above` frames up; returns the present name."""
    text = f"{name} is the older name of {_OLDER[name]}, until 2.0"
    warnings.warn(text, DeprecationWarning, stacklevel=above + 1)
    return _OLDER[name]


class Result:
    """Shows its class and its one line."""

    def __repr__(self) -> str:
        return f"<pygirth.{type(self).__name__}: {self._line()}>"

    def __getattr__(self, name: str) -> Any:
        """Members by their older names; called for names that an object lacks."""
        if _OLDER.get(name) in self.__dict__:
            return self.__dict__[warn_of_older(name, above=2)]
        raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")

    def _line(self) -> str:
        raise NotImplementedError
