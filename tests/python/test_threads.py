"""Long work leaves the interpreter to other threads, and can be interrupted."""

import _thread
import signal
import threading
from fractions import Fraction

import geargraph as gg
import pytest


def hours_of_work(robot, tmp_path):
    robot.analyze().film(tmp_path / "film.png", "motion", frames=10_000, size=(1600, 1000))


def test_ctrl_c_ends_the_work(robot, tmp_path):
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(KeyboardInterrupt):
            hours_of_work(robot, tmp_path)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert not list(tmp_path.iterdir())
    assert robot.analyze().rank == 4  # it goes on


def test_another_thread_runs_meanwhile_and_can_interrupt(robot, tmp_path):
    ran = []

    def interrupt():
        ran.append(sum(range(1_000_000)))  # needs the interpreter while the main thread works
        _thread.interrupt_main()

    thread = threading.Timer(0.1, interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        hours_of_work(robot, tmp_path)
    thread.join()
    assert ran


def test_threads_analyse_one_mechanism_at_once(robot):
    results = []
    shared = robot.analyze()

    def work():
        for _ in range(20):
            results.append((shared.solution.fractions.to_list(), robot.copy().analyze().joint_speeds))

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 80
    assert all(result == results[0] for result in results)


def test_an_error_of_a_thread_is_an_exception_there():
    errors = []

    def work():
        try:
            gg.Mechanism().analyze().picture()
        except gg.Error as error:
            errors.append(error.code)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert errors == ["undefined"]


def test_memory_does_not_grow_with_calls(robot):
    def resident():
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * 4  # kB

    def analyse(times):
        for _ in range(times):
            m = robot.copy()
            m.name = m.name + "'"
            assert m.analyze().solution.fractions is not None

    analyse(300)
    before = resident()
    analyse(1500)
    assert resident() - before < 4_000


def test_large_fractions_outlive_the_thread_that_made_them():
    m = gg.Mechanism()
    with m.edit():
        last = m.add_link()
        m.add_turning_joint(0, last)
        for _ in range(150):
            last = m.attach_gear(last, 0, (101, 97))
    expected = Fraction(101, 97) ** 150  # hundreds of digits, beyond what fits in a word
    found = []

    def work():
        for _ in range(5):
            a = m.copy().analyze(symbolic=False)
            speeds = a.joint_speeds
            a.solution, a.diagnostics
            found.append(abs(speeds[m.joints[-1].label]) * abs(speeds[m.joints[0].label]))
            found.append(abs(a.solution.fractions.at(149, 0)))

    threads = [threading.Thread(target=work) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    work()
    assert found == [expected] * 40
