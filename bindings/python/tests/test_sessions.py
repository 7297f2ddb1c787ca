"""Progress, cancelling, Ctrl+C, budgets, threads and forks."""

from __future__ import annotations

import gc
import os
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import sfumato
from conftest import TEXT


def interrupt_after(seconds):
    timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    return timer


def slow_drawing(large, **options):
    return sfumato.open(large, session=sfumato.Session(**options))


def test_progress_is_told_in_the_thread_that_called(evening):
    heard = []
    session = sfumato.Session(progress=lambda *news: heard.append((threading.get_ident(), *news)))
    sfumato.open(evening, session=session).solve(width=2000)
    assert heard and {thread for thread, _, _ in heard} == {threading.get_ident()}
    assert all(isinstance(stage, str) and 0 <= fraction <= 1 for _, stage, fraction in heard)


def test_what_progress_raises_ends_the_work_and_comes_out(large):
    class Stop(Exception):
        pass

    def stop(stage, fraction):
        raise Stop

    drawing = slow_drawing(large, progress=stop)
    with pytest.raises(Stop):
        drawing.solve()
    drawing._given.progress = None
    assert drawing.solve().layer_count > 0


def test_progress_may_cancel_and_nothing_else(large):
    drawing = slow_drawing(large)
    session = drawing._given
    session.progress = lambda stage, fraction: drawing.to_svg()
    with pytest.raises(RuntimeError):
        drawing.solve()
    session.progress = lambda stage, fraction: drawing.layers[0].curves[0].remove()
    with pytest.raises(RuntimeError):
        drawing.solve()
    session.progress = lambda stage, fraction: session.cancel()
    with pytest.raises(sfumato.Cancelled):
        drawing.solve()
    session.resume()
    session.progress = None
    drawing.solve()


def test_cancel_lasts_until_resume(drawing):
    session = sfumato.Session()
    drawing = sfumato.read(TEXT, session=session)
    session.cancel()
    assert session.cancelled
    for use in (drawing.solve, drawing.to_svg, drawing.field):
        with pytest.raises(sfumato.Cancelled):
            use()
    session.resume()
    drawing.solve()


def test_cancel_from_another_thread_ends_what_runs(large):
    drawing = slow_drawing(large, threads=1)
    timer = threading.Timer(0.05, drawing._given.cancel)
    timer.start()
    began = time.perf_counter()
    with pytest.raises(sfumato.Cancelled):
        for _ in range(50):
            drawing.solve(max_error=0.25, width=4000)
    assert time.perf_counter() - began < 20
    timer.join()


def test_an_interrupt_ends_what_the_main_thread_does(large):
    drawing = slow_drawing(large, threads=1)
    with pytest.raises(KeyboardInterrupt):
        timer = interrupt_after(0.1)
        for _ in range(50):
            drawing.solve(max_error=0.25, width=4000)
    timer.join()
    assert not drawing._given.cancelled
    drawing.layers[0].curves[0].left = "red"
    assert drawing.solve().layer_count > 0


@pytest.fixture
def alarms():
    """Raises an interrupt after a delay, by an alarm."""
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    yield
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.signal(signal.SIGALRM, before)


def test_interrupts_between_short_calls_leave_all_usable(drawing, alarms):
    curve = drawing.layers[0].curves[0]
    for round in range(60):
        with pytest.raises(KeyboardInterrupt):
            # Python drops an exception of a handler that runs while memory is released; the next
            # one arrives.
            signal.setitimer(signal.ITIMER_REAL, 0.002 + 0.0001 * round, 0.25)
            while True:
                curve.points = curve.points
                curve.left = curve.right.colors
                drawing.to_svg()
        signal.setitimer(signal.ITIMER_REAL, 0)
        done = threading.Thread(target=lambda: setattr(curve, "weight", 2), daemon=True)
        done.start()
        done.join(10)
        assert not done.is_alive()


def test_budgets_are_limit_errors(large):
    with pytest.raises(sfumato.LimitError):
        slow_drawing(large, max_memory=1).solve()
    with pytest.raises(sfumato.LimitError):
        slow_drawing(large, max_time=0.001).solve()
    with pytest.raises(sfumato.LimitError, match="curves"):
        sfumato.read(TEXT, session=sfumato.Session(limits={"curves": 2}))


def test_sessions_of_wrong_options_are_usage_errors():
    for bad in ({"threads": -1}, {"max_memory": 0}, {"max_time": -1}, {"simd": "mmx"},
                {"limits": {"no-such": 1}}, {"limits": {"curves": -1}}, {"threads": 1.5}):
        with pytest.raises(sfumato.UsageError):
            sfumato.Session(**bad)
    with pytest.raises(TypeError):
        sfumato.Session(progress="loud")
    with pytest.raises(TypeError):
        sfumato.Session(speed=3)


def test_threads_solve_and_draw_one_drawing_at_once(drawing):
    expected = drawing.render(128)
    picture = drawing.solve(width=128)

    def work(index):
        if index % 2:
            return picture.render(128)
        return drawing.render(128)

    with ThreadPoolExecutor(6) as pool:
        for image in pool.map(work, range(48)):
            np.testing.assert_array_equal(image, expected)


def test_one_session_serves_many_threads_in_turn():
    session = sfumato.Session(threads=1)
    drawing = sfumato.read(TEXT, session=session)
    expected = drawing.to_svg()
    with ThreadPoolExecutor(6) as pool:
        assert set(pool.map(lambda _: drawing.to_svg(), range(60))) == {expected}


def test_edits_and_solutions_in_threads_do_no_harm(drawing):
    layer, end = drawing.layers[0], time.perf_counter() + 2
    points = layer.curves[0].points

    def edit(index):
        while time.perf_counter() < end:
            curve = layer.add(points + index, left="red", right=["blue", "lime"])
            curve.left = "gold"
            curve.points = points
            curve.remove()

    def look(index):
        picture = drawing.solve()
        while time.perf_counter() < end:
            drawing.solve(again=picture)
            picture.render(32)
            drawing.to_svg()
            for curve in layer.curves:
                try:
                    assert len(curve.points) == 4
                except ValueError as error:
                    assert "removed" in str(error)
                except IndexError:
                    break

    with ThreadPoolExecutor(5) as pool:
        for future in [pool.submit(edit, i) for i in range(2)] + [pool.submit(look, i) for i in range(3)]:
            future.result()
    assert len(layer.curves) == 3


def test_what_is_freed_while_others_use_it_lives_until_they_end(large):
    drawing = sfumato.open(large)
    with ThreadPoolExecutor(2) as pool:
        future = pool.submit(drawing.solve)
        time.sleep(0.05)
        drawing.free()
        gc.collect()
        try:
            assert future.result().layer_count > 0
        except ValueError as error:  # freed before the other thread began
            assert "freed" in str(error)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
def test_a_child_makes_sessions_of_its_own(drawing):
    drawing.solve()
    session = sfumato.Session()
    child = os.fork()
    if child == 0:
        code = 1
        try:
            same = drawing.render(64).tobytes() == sfumato.read(TEXT).render(64).tobytes()
            try:
                sfumato.read(TEXT, session=session)
            except RuntimeError:
                code = 0 if same else 2
        finally:
            os._exit(code)
    for _ in range(600):
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            break
        time.sleep(0.1)
    else:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        pytest.fail("the child hangs")
    assert os.waitstatus_to_exitcode(status) == 0


def resident_bytes():
    gc.collect()
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_edits_do_not_leak(drawing):
    curve = drawing.layers[0].curves[0]

    def edit(times):
        for i in range(times):
            curve.left = [(i % 256 / 255, 0, 0), (0, 0, 1)]
            curve.points = curve.points
            curve.left.colors

    edit(2000)
    before = resident_bytes()
    edit(10000)
    assert resident_bytes() - before < 2**20


def test_handles_do_not_leak(drawing):
    def make(times):
        for _ in range(times):
            picture = drawing.copy().solve()
            picture.vertices(), picture.color_values()
            drawing.field().weights([(3, 3)])

    make(50)
    before = resident_bytes()
    make(200)
    assert resident_bytes() - before < 8 * 2**20
