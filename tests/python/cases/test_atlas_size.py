"""Atlases that are not square."""

import unittest

import numpy as np

import abflat
from judge import faults
from meshes import torus


class AtlasSize(unittest.TestCase):
    def test_width_and_height(self):
        positions, triangles = torus()
        for size in ((512, 256), [256, 512], np.array([300, 170]).tolist(), "300x170"):
            result = abflat.unwrap(positions, triangles, resolution=size)
            atlas = result.report["atlas"]
            wanted = [int(side) for side in size.split("x")] if isinstance(size, str) else list(size)
            self.assertEqual([atlas["width"], atlas["height"]], wanted)
            self.assertEqual(result.report["options"]["resolution"], wanted)
            self.assertTrue(result.valid)
            self.assertEqual(faults(result.uv, result.triangles), ([], []))

    def test_same_as_a_number(self):
        positions, triangles = torus()
        pair = abflat.unwrap(positions, triangles, resolution=(256, 256))
        number = abflat.unwrap(positions, triangles, resolution=256)
        np.testing.assert_array_equal(pair.uv, number.uv)

    def test_what_is_no_size(self):
        positions, triangles = torus()
        for size in ((256,), (256, 8), (256, 256, 256), (256, "wide"), (256.5, 256), (), 134218240):
            with self.assertRaises(abflat.AbflatError) as caught:
                abflat.unwrap(positions, triangles, resolution=size)
            self.assertEqual(caught.exception.code, "InvalidOption")
            self.assertIn("resolution cannot be", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
