"""Memory of the library's, and who may use it when."""

from __future__ import annotations

import threading
from types import TracebackType
from typing import Any, Optional, TypeVar

Self = TypeVar("Self", bound="Handle")


class Resource:
    """An object of the library with its lock. The object is freed when nobody refers to its pointer
    any more, unless the pointer is borrowed.

    The library lets several calls read an object while none changes it. A short call holds the
    lock. A long call reads with a lease, and changes wait for the lease to end. Ctrl+C may come
    between any two steps, so each of the two ends in a single step: releasing the lock, or removing
    the lease from a set.
    """

    def __init__(self, pointer: Any) -> None:
        self.pointer = pointer
        self.lock = threading.RLock()
        self.leases: set[Lease] = set()
        self.changing = 0  # the thread whose long call changes it; 0: none

    def is_read(self) -> bool:
        """Returns whether a change must wait without the lock that the caller holds. Raises
        RuntimeError if a call of this thread reads the resource, that is, inside that call's
        callback."""
        me = threading.get_ident()
        if any(lease.thread == me for lease in tuple(self.leases)):
            raise RuntimeError("in use by a call that has not returned yet")
        return bool(self.leases)


class Lease:
    """Marks that a thread reads a resource for a long time."""

    def __init__(self) -> None:
        self.thread = threading.get_ident()


class Handle:
    """An object of the library. It is freed by free(), at the end of a with block, or after its
    last use.

    After free() every use raises ValueError. Arrays that are views of its memory keep that memory
    alive.
    """

    def __init__(self, resource: Resource) -> None:
        self._resource: Optional[Resource] = resource

    def _held(self) -> Resource:
        """Returns the resource. Its pointer keeps the object alive."""
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
        """Releases the memory after all calls that use it have ended. May be called twice."""
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
