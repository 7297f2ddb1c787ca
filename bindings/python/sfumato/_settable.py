"""Properties for type checkers."""

from __future__ import annotations

from typing import Any, Callable, Generic, TypeVar, overload

Owner = TypeVar("Owner")
Got = TypeVar("Got")
Taken = TypeVar("Taken")


class Settable(Generic[Owner, Got, Taken]):
    """A property that accepts more types than it returns, for type checkers."""

    def __init__(self, get: Callable[[Owner], Got], put: Callable[[Owner, Taken], None]) -> None:
        self._get, self._put, self.__doc__ = get, put, get.__doc__

    @overload
    def __get__(self, owner: None, kind: Any) -> "Settable[Owner, Got, Taken]": ...
    @overload
    def __get__(self, owner: Owner, kind: Any) -> Got: ...
    def __get__(self, owner: Any, kind: Any) -> Any:
        return self if owner is None else self._get(owner)

    def __set__(self, owner: Owner, value: Taken) -> None:
        self._put(owner, value)
