"""Memory of the library's, and who may use it when."""

from __future__ import annotations

import threading
import weakref
from types import TracebackType
from typing import Callable, Optional, TypeVar

Self = TypeVar("Self", bound="Handle")


class Resource:
    """What the library gave out: given back once nobody holds this any more.

    The library lets several calls read a thing while none changes it. What is short holds the lock;
    what takes long reads with a lease, for which those that change the thing wait. Ctrl+C may come
    between any two steps, so that both end by one step each: the lock's, and that of a set.
    """

    def __init__(self, address: int, free: Optional[Callable[[int], object]]) -> None:
        self.address = address
        self.lock = threading.RLock()
        self.leases: set[Lease] = set()
        self.changing = 0  # the thread that changes it in a call that takes long; 0: none
        if free is not None:
            # At exit the system takes all back; arrays may still be looked at until then.
            weakref.finalize(self, free, address).atexit = False

    def is_read(self) -> bool:
        """Whether a change, for which one has the lock, has to wait without it. RuntimeError: a call of
        this thread reads it, whose callback this is."""
        me = threading.get_ident()
        if any(lease.thread == me for lease in tuple(self.leases)):
            raise RuntimeError("in use by a call that has not returned yet")
        return bool(self.leases)


class Lease:
    """That a thread reads something for long."""

    def __init__(self) -> None:
        self.thread = threading.get_ident()


class Handle:
    """A thing of the library's: freed by free(), at the end of a with block, or with its last use.

    After free() every use raises ValueError; arrays that are views of its memory keep that alive.
    """

    def __init__(self, resource: Resource) -> None:
        self._resource: Optional[Resource] = resource

    def _held(self) -> Resource:
        """Hold the result as long as its address is used."""
        resource = self._resource
        if resource is None:
            raise ValueError(f"this {type(self).__name__} was freed")
        if resource.changing == threading.get_ident():
            raise RuntimeError("being changed by a call that has not returned yet")
        return resource

    @property
    def freed(self) -> bool:
        """Whether free() was called."""
        return self._resource is None

    def free(self) -> None:
        """Gives the memory back, once calls that use it have ended. May be called twice."""
        self._resource = None

    def __enter__(self: Self) -> Self:
        self._held()
        return self

    def __exit__(
        self,
        kind: Optional[type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        self.free()

    def __reduce__(self) -> str:
        raise TypeError(f"a {type(self).__name__} cannot be pickled; a drawing's to_svg() can")
