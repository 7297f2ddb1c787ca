"""Sessions: threads, budgets, progress and cancelling. Every call of the library runs in one."""

from __future__ import annotations

import functools
import os
import threading
import time
import warnings
from typing import Any, Callable, Mapping, Optional

from ._errors import DrawingWarning, Error, error_of, text_of
from ._flight import Flight
from ._handle import Lease, Resource
from ._library import ffi, lib
from ._options import Option, encode

Progress = Callable[[str, float], object]

_WAIT = 0.001  # seconds between checks whether other calls have ended


class Session:
    """Threads, memory and time that work may use.

    threads: their count [all cores]. max_memory: MiB for the work and for the objects made in the
    session [2048]. max_time: seconds that a call may take. limits: limits for inputs, by the names
    in docs/limits.md. simd: "sse2", "avx2" or "avx512". progress: called with a stage ("gather")
    and a fraction from 0 to 1, in the thread that works with Sfumato. An exception in it ends the
    work and leaves the call. It may call cancel() and nothing else of the session.

    Every function takes a session; without one it uses a session of its own thread. A session does
    one task at a time; other calls wait. Ctrl+C ends the work of the main thread within about 50
    ms.
    """

    def __init__(
        self,
        *,
        threads: Optional[int] = None,
        max_memory: Optional[int] = None,
        max_time: Optional[float] = None,
        limits: Optional[Mapping[str, int]] = None,
        simd: Optional[str] = None,
        progress: Optional[Progress] = None,
    ) -> None:
        options: dict[str, Option] = {
            "threads": threads,
            "max-memory": max_memory,
            "max-time": max_time,
            "simd": simd,
            **{f"limit.{name}": value for name, value in (limits or {}).items()},
        }
        if progress is not None and not callable(progress):
            raise TypeError("progress is a function of a stage and a fraction")
        made = lib.sfumato_context_new(encode(options))
        if not made:
            raise MemoryError("no memory for a session")
        self._context: Any = ffi.gc(made, lib.sfumato_context_free)
        if text_of(lib.sfumato_error_text(made)):
            raise error_of(made, lib.SFUMATO_BAD_USAGE) or Error("no session")
        self.progress = progress
        self._process = os.getpid()
        self._one = threading.RLock()
        self._flight: Optional[Flight] = None
        self._is_lent = False  # to a callback that may use the session
        self._cancelled = False

    def cancel(self) -> None:
        """Ends the running call, and all later ones until resume(), with Cancelled. May be called
        from any thread or in a callback."""
        self._cancelled = True
        lib.sfumato_cancel(self._context)

    def resume(self) -> None:
        """Lets the session work again."""
        self._cancelled = False
        lib.sfumato_resume(self._context)

    @property
    def cancelled(self) -> bool:
        """Whether cancel() was called and resume() was not called since."""
        return self._cancelled

    # The rest is internal to this package.

    def call(
        self,
        name: str,
        *arguments: Any,
        reads: Optional[Resource] = None,
        changes: Optional[Resource] = None,
        slow: bool = False,
    ) -> None:
        """Calls sfumato_NAME with the context and these arguments, or raises its error.

        slow: the call may take long; it reacts to interrupts and reports progress.
        """
        if reads is None:
            return self._change(name, arguments, changes, slow)
        lease = Lease()
        with self._turn:
            self._check_turn()
            try:
                with reads.lock:
                    reads.leases.add(lease)
                self._change(name, arguments, changes, slow)
            finally:
                reads.leases.discard(lease)

    def _change(
        self, name: str, arguments: tuple[Any, ...], changes: Optional[Resource], slow: bool
    ) -> None:
        with self._turn:
            self._check_turn()
            if changes is None:
                return self._do(name, arguments, slow)
            while True:
                with changes.lock:
                    if not changes.is_read():
                        try:
                            changes.changing = threading.get_ident()
                            return self._do(name, arguments, slow)
                        finally:
                            changes.changing = 0
                time.sleep(_WAIT)

    def edit(
        self,
        name: str,
        resource: Resource,
        place: Callable[[], tuple[Any, ...]],
        rest: tuple[Any, ...],
        after: Optional[Callable[[], None]] = None,
    ) -> None:
        """Changes a resource: calls place(), the function and after() while nobody else uses the
        resource."""
        with self._turn:
            self._check_turn()
            while True:
                with resource.lock:
                    if not resource.is_read():
                        self._do(name, (resource.pointer, *place(), *rest), False)
                        return None if after is None else after()
                time.sleep(_WAIT)

    def _check_turn(self) -> None:
        if self._flight is not None and not self._is_lent:
            raise RuntimeError("a progress function may call cancel(), and nothing else")

    @property
    def _turn(self) -> threading.RLock:
        if self._process != os.getpid():
            raise RuntimeError("this session belongs to the process from which this one was forked")
        return self._one

    def _do(self, name: str, arguments: tuple[Any, ...], slow: bool) -> None:
        function = getattr(lib, "sfumato_" + name)
        status = (self._fly if slow else _directly)(function, (self._context, *arguments))
        error = error_of(self._context, status)
        if error is not None:
            raise error

    def make(self, name: str, *arguments: Any, **how: Any) -> Resource:
        """The same for calls that return a new object. sfumato_TYPE_free() frees it."""
        place = ffi.typeof(getattr(lib, "sfumato_" + name)).args[-1]
        free = getattr(lib, place.item.item.cname.removeprefix("struct ") + "_free")
        out = ffi.new(place)
        try:
            self.call(name, *arguments, out, **how)
        finally:  # a callback may raise an exception and the call still make an object
            made = ffi.gc(out[0], free)
        return Resource(made)

    def make_bytes(self, name: str, *arguments: Any, **how: Any) -> bytes:
        made = self.make(name, *arguments, **how).pointer
        return bytes(ffi.buffer(lib.sfumato_bytes_data(made), lib.sfumato_bytes_size(made)))

    def ask(self, answer: Callable[[], Any]) -> Any:
        """In a callback of a slow call: runs answer() in the caller's thread, which may use the
        session meanwhile."""
        flight = self._flight
        assert flight is not None

        def lent() -> Any:
            self._is_lent, was = True, self._is_lent
            try:
                return answer()
            finally:
                self._is_lent = was

        return flight.ask(lent)

    def last_warnings(self) -> list[str]:
        """Returns the warnings of the last call, each with its place."""
        found: list[str] = []
        while words := lib.sfumato_warning(self._context, len(found)):
            found.append(text_of(words))
        return found

    def warn(self, level: int = 3) -> None:
        """Raises the warnings of the last call as Python warnings."""
        for words in self.last_warnings():
            warnings.warn(words, DrawingWarning, stacklevel=level + 1)

    def _fly(self, function: Callable[..., int], arguments: tuple[Any, ...]) -> int:
        flight, outer = Flight(lambda: lib.sfumato_cancel(self._context)), self._flight
        lent = self._is_lent
        told = None
        try:
            self._flight, self._is_lent = flight, False
            if self.progress is not None and outer is None:
                told = ffi.callback("sfumato_progress_fn", self._tell)
                lib.sfumato_set_progress(self._context, told, ffi.NULL)
            return flight.run(function, arguments)
        finally:
            self._flight, self._is_lent = outer, lent
            if told is not None:
                lib.sfumato_set_progress(self._context, ffi.NULL, ffi.NULL)
            if not self._cancelled:
                lib.sfumato_resume(self._context)

    def _tell(self, _: Any, stage: Any, fraction: float) -> None:
        flight, hears = self._flight, self.progress
        if flight is not None and hears is not None:
            flight.tell(functools.partial(hears, text_of(stage), fraction))


def _directly(function: Callable[..., int], arguments: tuple[Any, ...]) -> int:
    return function(*arguments)


_own = threading.local()


def session_of(given: Optional[Session]) -> Session:
    """Returns the given session, or the session of this thread."""
    if given is not None:
        return given
    if not hasattr(_own, "session") or _own.session._process != os.getpid():
        _own.session = Session()
    found: Session = _own.session
    return found
