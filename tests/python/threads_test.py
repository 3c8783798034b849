"""Python's other threads go on while the library works."""
import sys
import threading
import time
import unittest

import honeycomb
import numpy as np
from shapes import CREATURE


class Ticks(threading.Thread):
    """Counts, and gives the interpreter's lock away after each."""

    def __init__(self):
        super().__init__(daemon=True)
        self.count, self.wanted = 0, True

    def run(self):
        while self.wanted:
            self.count += 1
            time.sleep(0)


class Lock(unittest.TestCase):
    def setUp(self):
        # Nobody is asked to give the lock away any more: who counts meanwhile got it from the library.
        self.addCleanup(sys.setswitchinterval, sys.getswitchinterval())
        sys.setswitchinterval(1000)
        self.ticks = Ticks()
        self.ticks.start()
        self.addCleanup(self.ticks.join)
        self.addCleanup(setattr, self.ticks, "wanted", False)

    def check_given_away(self, call):
        give_up = time.monotonic() + 30
        while time.monotonic() < give_up:
            before = self.ticks.count
            call()
            if self.ticks.count > before:
                return
            time.sleep(0)
        self.fail("the lock was held all the while")

    def test_is_given_away_by_everything_that_takes_time(self):
        mesh = honeycomb.Mesh.read(CREATURE)
        tables = honeycomb.Tables(mesh, levels=2, limits=True)
        evaluator = honeycomb.Evaluator(tables)
        points = evaluator.refine(mesh.points)
        calls = {"Mesh.read": lambda: honeycomb.Mesh.read(CREATURE),
                 "Tables": lambda: honeycomb.Tables(mesh),
                 "refine": lambda: evaluator.refine(mesh.points, out=points),
                 "limits": lambda: evaluator.limits(points),
                 "triangles": tables.triangles}
        for name, call in calls.items():
            with self.subTest(name):
                self.check_given_away(call)

    def test_is_kept_by_what_is_python(self):
        """The test of the test: nothing counts while Python alone works."""
        before = self.ticks.count
        sum(range(10000))
        self.assertEqual(before, self.ticks.count)


class SharedEvaluator(unittest.TestCase):
    def test_gives_each_thread_its_own_points(self):
        mesh = honeycomb.Mesh.read(CREATURE)
        evaluator = honeycomb.Evaluator(honeycomb.Tables(mesh, tiles=True))
        poses = [np.ascontiguousarray(mesh.points * np.float32(scale)) for scale in (1, 2, 3, 4)]
        alone = [evaluator.refine(pose) for pose in poses]
        together = [[] for _ in poses]
        barrier = threading.Barrier(len(poses), timeout=60)

        def work(pose, results):
            barrier.wait()
            results.extend(evaluator.refine(pose) for _ in range(8))

        threads = [threading.Thread(target=work, args=pair, daemon=True) for pair in zip(poses, together)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(60)
        for expected, results in zip(alone, together):
            self.assertEqual(8, len(results))
            for result in results:
                np.testing.assert_array_equal(expected, result)


if __name__ == "__main__":
    unittest.main()
