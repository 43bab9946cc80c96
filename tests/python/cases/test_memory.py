"""Memory of many calls."""

import resource
import unittest

import abflat
from meshes import hill


def peak():
    """Most memory of this process so far, in KiB."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


class Memory(unittest.TestCase):
    def test_many_calls_take_no_more_than_a_few(self):
        positions, triangles = hill()

        def call():
            abflat.unwrap(positions, triangles, resolution=64)
            with self.assertRaises(abflat.AbflatError):
                abflat.unwrap(positions, triangles, padding=64, resolution=64)

        for _ in range(20):
            call()
        before = peak()
        for _ in range(200):
            call()
        self.assertLess(peak() - before, 4096)


if __name__ == "__main__":
    unittest.main()
