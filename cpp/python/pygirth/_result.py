"""How results show themselves."""


class Result:
    """Shows its class and its one line."""

    def __repr__(self) -> str:
        return f"<pygirth.{type(self).__name__}: {self._line()}>"

    def _line(self) -> str:
        raise NotImplementedError
