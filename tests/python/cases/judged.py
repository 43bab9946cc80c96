"""What the tests of abflat.xatlas share."""

import unittest

import numpy as np

from abflat import xatlas
from judge import faults


def options(kind, **values):
    made = kind()
    for name, value in values.items():
        setattr(made, name, value)
    return made


def generated(*meshes, **values):
    atlas = xatlas.Atlas()
    for mesh in meshes:
        atlas.add_mesh(*mesh)
    atlas.generate(pack_options=options(xatlas.PackOptions, **values))
    return atlas


class Judged(unittest.TestCase):
    def check_arrays(self, result, positions, faces):
        vmapping, indices, uvs = result
        self.assertEqual((vmapping.dtype, vmapping.ndim), (np.uint32, 1))
        self.assertEqual((indices.dtype, indices.shape), (np.uint32, np.shape(faces)))
        self.assertEqual((uvs.dtype, uvs.shape), (np.float32, (len(vmapping), 2)))
        self.assertTrue((uvs >= 0).all() and (uvs <= 1).all())
        np.testing.assert_array_equal(
            np.asarray(positions)[vmapping][indices], np.asarray(positions)[faces]
        )
        self.assertEqual(set(indices.reshape(-1).tolist()), set(range(len(vmapping))))

    def check(self, result, positions, faces):
        self.check_arrays(result, positions, faces)
        self.assertEqual(faults(result[2], result[1]), ([], []))
