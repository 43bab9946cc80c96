"""The calls that programs make to xatlas, one after the other as they do."""

import sys
import unittest
from unittest.mock import patch

import numpy as np

from abflat import xatlas
from abflat import xatlas as abflat_xatlas
from judge import faults
from meshes import torus


class Trimesh:
    """As much of trimesh.Trimesh as these programs use."""

    def __init__(self, vertices, faces, visual=None):
        self.vertices, self.faces, self.visual = vertices, faces, visual


class Pipelines(unittest.TestCase):
    def setUp(self):
        self.mesh = Trimesh(*torus())

    def check(self, vertices, faces, uvs):
        np.testing.assert_array_equal(vertices[faces], self.mesh.vertices[self.mesh.faces])
        self.assertEqual(faults(uvs, faces), ([], []))

    def test_hunyuan3d(self):
        mesh = self.mesh
        vmapping, indices, uvs = xatlas.parametrize(mesh.vertices, mesh.faces)
        before = mesh.vertices[vmapping]
        self.check(before, indices, uvs)

    def test_instant_mesh(self):
        v_pos, t_pos_idx = self.mesh.vertices.astype(np.float32), self.mesh.faces
        atlas = xatlas.Atlas()
        atlas.add_mesh(v_pos, t_pos_idx)
        chart_options = xatlas.ChartOptions()
        pack_options = xatlas.PackOptions()
        for key, value in {"padding": 2}.items():
            setattr(pack_options, key, value)
        atlas.generate(chart_options, pack_options)
        vmapping, indices, uvs = atlas.get_mesh(0)
        # torch has no type for them.
        faces = indices.astype(np.uint64, casting="same_kind").view(np.int64)
        mapping = vmapping.astype(np.uint64, casting="same_kind").view(np.int64)
        self.check(self.mesh.vertices[mapping], faces, uvs)

    def test_trellis(self):
        vertices, faces = self.mesh.vertices.astype(np.float32), self.mesh.faces.astype(np.int32)
        vmapping, indices, uvs = xatlas.parametrize(vertices, faces)
        self.check(self.mesh.vertices[vmapping], indices, uvs)

    def test_tripo_sr(self):
        texture_resolution = 512
        atlas = xatlas.Atlas()
        atlas.add_mesh(self.mesh.vertices, self.mesh.faces)
        options = xatlas.PackOptions()
        options.resolution = texture_resolution
        options.padding = round(max(2, texture_resolution / 256))
        options.bilinear = True
        atlas.generate(pack_options=options)
        vmapping, indices, uvs = atlas[0]
        self.assertEqual(atlas.width, texture_resolution)
        self.check(self.mesh.vertices[vmapping], indices, uvs)

    def test_trimesh(self):
        # It imports xatlas itself.
        with patch.dict(sys.modules, xatlas=abflat_xatlas):
            import xatlas
        mesh = self.mesh
        vmap, faces, uv = xatlas.parametrize(mesh.vertices, mesh.faces)
        result = Trimesh(vertices=mesh.vertices[vmap], faces=faces, visual=uv)
        self.check(result.vertices, result.faces, result.visual)
