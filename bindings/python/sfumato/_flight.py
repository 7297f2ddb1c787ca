"""Runs a call of the library in its own thread, while the caller's thread handles interrupts and
callbacks."""

from __future__ import annotations

import collections
import os
import queue
import threading
from typing import Any, Callable, Optional


class _Worker:
    """A thread that runs flights one after the other."""

    def __init__(self) -> None:
        self.flights: queue.SimpleQueue[Flight] = queue.SimpleQueue()
        threading.Thread(target=self._serve, name="sfumato", daemon=True).start()

    def _serve(self) -> None:
        while True:
            flight = self.flights.get()
            flight.work()
            del flight  # and its arguments


_idle: collections.deque[_Worker] = collections.deque()
os.register_at_fork(after_in_child=_idle.clear)


def _worker() -> _Worker:
    try:
        return _idle.pop()
    except IndexError:
        return _Worker()


class _Question:
    """A question of the call to the caller's thread; the call waits for the answer."""

    def __init__(self, answer: Callable[[], Any]) -> None:
        self.answer = answer
        self.reply: queue.SimpleQueue[Any] = queue.SimpleQueue()


class Flight:
    """run() calls a C function in another thread and returns its result.

    Python handles Ctrl+C between two steps of its main thread. If an interrupt or a callback raises
    an exception here while the call runs, the call is cancelled, and the exception is raised again
    after the call has ended. An interrupt may come between any two steps. Therefore the threads
    wait for queues, whose operations are atomic, and check all state again afterwards.
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
        """From any thread: asks for hear() to be called in the caller's thread, unless a newer one
        replaces it."""
        self._latest = hear
        self._news.put(None)

    def ask(self, answer: Callable[[], Any]) -> Any:
        """From the call's thread: returns the result of answer() in the caller's thread; None if it
        raises."""
        question = _Question(answer)
        self._questions.append(question)
        self._news.put(None)
        return question.reply.get()

    def run(self, function: Callable[..., int], arguments: tuple[Any, ...]) -> int:
        self._call = (function, arguments)
        worker, is_given = _worker(), False
        while not self._finished:
            try:
                if not is_given:  # an interrupt may come before this is noted; a flight given twice runs once
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
        """Runs in the worker's thread."""
        call, self._call = self._call, None
        if call is None:
            return
        function, arguments = call
        try:
            self._status = function(*arguments)
        except BaseException as error:  # an argument that cffi does not accept
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
