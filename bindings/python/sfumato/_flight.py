"""A call of the library's in a thread of its own, while the caller's hears interrupts and callbacks."""

from __future__ import annotations

import collections
import os
import queue
import threading
from typing import Any, Callable, Optional


class _Worker:
    """A thread that runs flights, one after the other."""

    def __init__(self) -> None:
        self.flights: queue.SimpleQueue[Flight] = queue.SimpleQueue()
        threading.Thread(target=self._serve, name="sfumato", daemon=True).start()

    def _serve(self) -> None:
        while True:
            flight = self.flights.get()
            flight.work()
            del flight  # and what it was called with


_idle: collections.deque[_Worker] = collections.deque()
os.register_at_fork(after_in_child=_idle.clear)


def _worker() -> _Worker:
    try:
        return _idle.pop()
    except IndexError:
        return _Worker()


class _Question:
    """What the call asks of the caller's thread, and waits for."""

    def __init__(self, answer: Callable[[], Any]) -> None:
        self.answer = answer
        self.reply: queue.SimpleQueue[Any] = queue.SimpleQueue()


class Flight:
    """run() calls a function of C in another thread and returns what it gives.

    So Ctrl+C, which Python looks at between two steps of its main thread, ends a call that takes
    long: whatever is raised here meanwhile, by an interrupt or by a callback, cancels the call and is
    raised once that has ended. An interrupt may come between any two steps, so that what the threads
    wait for are queues, whose steps are whole, and everything is looked at again afterwards.
    """

    def __init__(self, cancel: Callable[[], object]) -> None:
        self._cancel = cancel
        self._news: queue.SimpleQueue[None] = queue.SimpleQueue()
        self._questions: collections.deque[_Question] = collections.deque()
        self._latest: Optional[Callable[[], Any]] = None
        self._call: Optional[tuple[Callable[..., int], tuple[Any, ...]]] = None
        self._finished = False
        self._status = 0
        self._failure: Optional[BaseException] = None

    def tell(self, hear: Callable[[], Any]) -> None:
        """From any thread: hear() is called in the caller's, unless something newer comes first."""
        self._latest = hear
        self._news.put(None)

    def ask(self, answer: Callable[[], Any]) -> Any:
        """From the thread of the call: what answer() returns in the caller's; None where it raises."""
        question = _Question(answer)
        self._questions.append(question)
        self._news.put(None)
        return question.reply.get()

    def run(self, function: Callable[..., int], arguments: tuple[Any, ...]) -> int:
        self._call = (function, arguments)
        worker, is_given = _worker(), False
        while not self._finished:
            try:
                if not is_given:  # an interrupt may come before the note of it: given twice, run once
                    worker.flights.put(self)
                    is_given = True
                self._look()
                self._news.get()
            except BaseException as error:
                self._failure = self._failure or error
                self._cancel()
        _idle.append(worker)
        if self._failure is not None:
            raise self._failure
        return self._status

    def work(self) -> None:
        """In the worker's thread."""
        call, self._call = self._call, None
        if call is None:
            return
        function, arguments = call
        try:
            self._status = function(*arguments)
        except BaseException as error:  # an argument that ctypes does not take
            self._failure = self._failure or error
        self._finished = True
        self._news.put(None)

    def _look(self) -> None:
        """Answers what waits; a question twice where an interrupt came between, but then by None."""
        while self._questions:
            question, result = self._questions[0], None
            try:
                if self._failure is None:
                    result = question.answer()
            finally:
                question.reply.put(result)
            self._questions.popleft()
        hear, self._latest = self._latest, None
        if hear is not None and self._failure is None:
            hear()
