"""The judge sees the faults that the other tests would miss without it."""

import unittest

from judge import faults


class Judge(unittest.TestCase):
    def test_faults(self):
        square = [[0, 0], [1, 0], [1, 1], [0, 1]]
        self.assertEqual(faults(square, [[0, 1, 2], [0, 2, 3]]), ([], []))
        self.assertEqual(faults(square, [[0, 1, 2], [0, 3, 2]]), ([1], []))
        self.assertEqual(faults(square, [[0, 1, 2], [0, 1, 3]]), ([], [(0, 1)]))
        hair = [[0, 0], [1, 0], [1, 1], [0, 1], [1, -(2**-60)]]
        self.assertEqual(faults(hair, [[0, 1, 2], [0, 4, 1]]), ([], []))
        self.assertEqual(faults(hair, [[0, 4, 2], [0, 1, 3]]), ([], [(0, 1)]))
