"""Progress, cancelling and other threads during a run."""

import signal
import sys
import threading
import time
import unittest
from contextlib import contextmanager

import numpy as np

import abflat
from meshes import grid, torus


def rough(size):
    """Enough work that a run does not end before other threads have had a turn."""
    heights = np.random.default_rng(1).random((size + 1, size + 1))
    return grid(size, size, lambda i, j: (i, j, 2 * heights[i, j]))


class Progress(unittest.TestCase):
    def test_stages_and_fractions(self):
        calls = []
        abflat.unwrap(*torus(), progress=lambda stage, fraction: calls.append((stage, fraction)))
        self.assertTrue({"seams", "solve", "pack"} <= {stage for stage, _ in calls}, calls)
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction in calls))

    def test_it_is_called_on_the_thread_of_the_caller(self):
        threads = set()
        abflat.unwrap(*torus(), progress=lambda *_: threads.add(threading.current_thread()))
        self.assertEqual(threads, {threading.current_thread()})

    def test_an_exception_ends_the_run_and_comes_out(self):
        class Stop(Exception):
            pass

        for call in (abflat.unwrap, abflat.flatten):
            stages = []

            def stop(stage, _):
                stages.append(stage)
                raise Stop("enough")

            with self.assertRaisesRegex(Stop, "enough"):
                call(*rough(4), progress=stop)
            self.assertEqual(len(stages), 1, "it is not called again")
        self.assertTrue(abflat.unwrap(*torus()).valid, "the next run is not cancelled")

    def test_a_run_within_a_run(self):
        inner = []

        def unwrap_another(*_):
            if not inner:
                inner.append(abflat.unwrap(*torus(8, 6)))

        self.assertTrue(abflat.unwrap(*torus(), progress=unwrap_another).valid)
        self.assertTrue(inner[0].valid)


class Threads(unittest.TestCase):
    """With such an interval, a thread that has the GIL keeps it until it lets go by itself."""

    def setUp(self):
        self.addCleanup(sys.setswitchinterval, sys.getswitchinterval())
        sys.setswitchinterval(1000)
        # Its setdefault receives the progress. It is no Python code, which would look for signals.
        self.stages = {}

    def test_ctrl_c_ends_the_run(self):
        main = threading.main_thread().ident
        mesh = rough(60)

        def interrupt(is_running):
            if is_running():
                signal.pthread_kill(main, signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            with self.during_a_run(interrupt):
                abflat.unwrap(*mesh, progress=self.stages.setdefault)
        self.assertNotIn("check", self.stages, "it has not run to its end")

    def test_other_threads_run_meanwhile(self):
        mesh, turns = rough(20), []

        def work(is_running):
            while is_running():
                turns.append(1)
                time.sleep(0)

        with self.during_a_run(work):
            abflat.unwrap(*mesh, progress=self.stages.setdefault)
            meanwhile = len(turns)
        self.assertGreater(meanwhile, 0)

    @contextmanager
    def during_a_run(self, work):
        """Another thread does this once the run of this one has begun."""
        done = threading.Event()

        def start():
            while not self.stages and not done.is_set():
                time.sleep(0)
            work(lambda: not done.is_set())

        worker = threading.Thread(target=start)
        worker.start()
        try:
            yield
        finally:
            done.set()
            worker.join()


class Parallel(unittest.TestCase):
    def test_runs_side_by_side_give_the_same(self):
        expected = abflat.unwrap(*torus()).uv
        results = [None] * 4

        def run(k):
            results[k] = abflat.unwrap(*torus()).uv

        workers = [threading.Thread(target=run, args=(k,)) for k in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        for uv in results:
            np.testing.assert_array_equal(uv, expected)
