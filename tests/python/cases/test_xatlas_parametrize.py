"""abflat.xatlas.parametrize and export: the arrays of xatlas-python, and layouts without faults."""

import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

from abflat import xatlas
from judge import faults
from judged import Judged
from meshes import cube, hill, soup, torus


class Parametrize(Judged):
    def test_layouts(self):
        for mesh in (cube(), torus(), hill()):
            self.check(xatlas.parametrize(*mesh), *mesh)

    def test_every_kind_of_array(self):
        positions, faces = torus()
        expected = xatlas.parametrize(positions, faces)
        for p, f in (
            (positions.tolist(), faces.tolist()),
            (np.asfortranarray(positions), faces.astype(np.uint32)),
            (positions, faces.astype(float)),
        ):
            for got, wanted in zip(xatlas.parametrize(p, f), expected):
                np.testing.assert_array_equal(got, wanted)

    def test_vertices_that_no_face_uses_are_left_out(self):
        positions, faces = cube()
        more = np.concatenate([positions, [[9, 9, 9], [np.nan, 0, 0]]])
        vmapping, _, _ = xatlas.parametrize(more, faces)
        self.assertEqual(set(vmapping.tolist()), set(range(8)))

    def test_nothing_fails(self):
        positions, faces = cube()
        nan = positions.copy()
        nan[0, 1] = np.nan
        twice = np.concatenate([faces, faces[:4], faces[::-1, ::-1]])
        fan = [[0, 1, 2], [0, 1, 3], [0, 1, 4], [0, 1, 6]]
        for points, triangles in (
            ([], []),
            (positions, []),
            (positions, [[0, 0, 0]]),
            (positions, [[0, 1, 1], *faces.tolist(), [2, 2, 3]]),
            (positions * 0, faces),
            (nan, faces),
            (positions, twice),
            (positions, fan),
            (positions * 1e-30, faces),
            (positions * 1e30, faces),
            *(soup(seed) for seed in range(4)),
        ):
            points = np.reshape(points, (-1, 3)).astype(float)
            triangles = np.reshape(triangles, (-1, 3)).astype(int)
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                self.check_arrays(xatlas.parametrize(points, triangles), points, triangles)

    def test_soups_have_no_faults(self):
        for seed in range(4):
            positions, faces = soup(seed)
            _, indices, uvs = xatlas.parametrize(positions, faces)
            proper = [len(set(face)) == 3 for face in faces.tolist()]
            self.assertEqual(faults(uvs, indices[proper]), ([], []))


class Export(unittest.TestCase):
    def test_it_can_be_read_again(self):
        positions, faces = cube()
        vmapping, indices, uvs = xatlas.parametrize(positions, faces)
        with tempfile.TemporaryDirectory() as folder:
            for normals, corner in ((None, "{0}/{0}"), (positions[vmapping], "{0}/{0}/{0}")):
                path = Path(folder, "out.obj")
                xatlas.export(path, positions[vmapping], indices, uvs, normals)
                words = [line.split() for line in path.read_text().splitlines()]
                numbers = lambda word: [float(x) for x in word[1:]]
                read = lambda key: np.array([numbers(w) for w in words if w[0] == key])
                np.testing.assert_array_equal(read("v"), positions[vmapping])
                np.testing.assert_array_equal(read("vt").astype(np.float32), uvs)
                self.assertEqual(
                    [w[1:] for w in words if w[0] == "f"],
                    [[corner.format(v + 1) for v in face] for face in indices],
                )
