"""abflat.xatlas.Atlas: several meshes, charts, and what it says of them."""

import numpy as np

from abflat import xatlas
from judge import areas, faults
from judged import Judged, generated
from meshes import cube, hill, torus

NONE = 2**32 - 1


class Atlas(Judged):
    def test_meshes_share_an_atlas(self):
        meshes = cube(), torus(), cube()
        atlas = generated(*meshes)
        self.assertEqual((len(atlas), atlas.mesh_count, atlas.atlas_count), (3, 3, 1))
        corners, triangles = [], []
        for i, mesh in enumerate(meshes):
            self.check(atlas[i], *mesh)
            _, indices, uvs = atlas.get_mesh(i)
            triangles += (indices + sum(map(len, corners))).tolist()
            corners.append(uvs)
        self.assertEqual(faults(np.concatenate(corners), triangles), ([], []))

    def test_numbers(self):
        atlas = generated(cube(), torus(), resolution=512, padding=3)
        self.assertEqual((atlas.width, atlas.height), (512, 512))
        covered = 0
        for (positions, faces), i in ((cube(), 0), (torus(), 1)):
            vmapping, indices, uvs = atlas[i]
            area = areas(uvs, indices).sum()
            covered += area
            a, b, c = np.moveaxis(positions[faces], 1, 0)
            surface = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
            ratio = area * 512**2 / (surface * atlas.texels_per_unit**2)
            self.assertAlmostEqual(ratio, 1, delta=0.1)
        self.assertAlmostEqual(atlas.utilization, covered, places=6)
        self.assertEqual(atlas.get_utilization(0), atlas.utilization)

    def test_charts_and_assignments(self):
        # Side by side they are one surface, but not as two meshes.
        positions, triangles = hill()
        is_left = positions[triangles][:, :, 0].mean(axis=1) < 4
        meshes = (positions, triangles[is_left]), (positions, triangles[~is_left])
        atlas = generated(*meshes)
        counts = [atlas.get_mesh_chart_count(i) for i in range(2)]
        self.assertEqual(sum(counts), atlas.chart_count)
        seen = set()
        for i, (_, faces) in enumerate(meshes):
            tiles, charts = atlas.get_mesh_vertex_assignment(i)
            self.assertEqual((tiles.dtype, charts.dtype), (np.uint32, np.uint32))
            self.assertEqual(set(tiles.tolist()), {0})
            members = []
            for j in range(counts[i]):
                chart = atlas.get_mesh_chart(i, j)
                members += chart.faces.tolist()
                number = set(charts[atlas[i][1][chart.faces]].reshape(-1).tolist())
                self.assertEqual(len(number), 1)
                self.assertTrue(number.isdisjoint(seen))
                seen |= number
            self.assertEqual(sorted(members), list(range(len(faces))))

    def test_what_is_not_drawn_has_no_chart(self):
        positions, faces = cube()
        atlas = generated((positions, [*faces.tolist(), [1, 1, 2]]))
        vmapping, indices, uvs = atlas[0]
        tiles, charts = atlas.get_mesh_vertex_assignment(0)
        self.assertEqual(set(tiles[indices[-1]].tolist()), {NONE})
        self.assertEqual(set(charts[indices[-1]].tolist()), {NONE})
        self.assertTrue((uvs[indices[-1]] == 0).all())

    def test_uv_meshes_are_packed_as_they_are(self):
        positions, faces = torus()
        _, indices, uvs = xatlas.parametrize(positions, faces)
        # In the second, all charts lie on others.
        twice = np.concatenate([uvs, uvs]), np.concatenate([indices, indices + len(uvs)])
        meshes = (uvs, indices), twice, (uvs * 2, indices)
        atlas = xatlas.Atlas()
        for mesh in meshes:
            atlas.add_uv_mesh(*mesh)
        atlas.generate()
        corners, triangles = [], []
        for i, (given, given_faces) in enumerate(meshes):
            vmapping, packed, found = atlas[i]
            np.testing.assert_array_equal(vmapping[packed], given_faces)
            size = lambda uv, t: np.linalg.norm(uv[t[:, 1]] - uv[t[:, 0]], axis=1)
            ratio = size(found.astype(float), packed) / size(given.astype(float), given_faces)
            np.testing.assert_allclose(ratio * atlas.width, atlas.texels_per_unit, rtol=1e-3)
            triangles += (packed + sum(map(len, corners))).tolist()
            corners.append(found)
        self.assertEqual(faults(np.concatenate(corners), triangles), ([], []))
        with self.assertRaisesRegex(RuntimeError, "not both"):
            atlas.add_mesh(positions, faces)

    def test_before_generate(self):
        atlas = xatlas.Atlas()
        self.assertEqual((len(atlas), atlas.chart_count, atlas.width), (0, 0, 0))
        calls = lambda: atlas[0], lambda: atlas.utilization, lambda: atlas.get_mesh_chart(0, 0)
        for call in calls:
            with self.assertRaisesRegex(IndexError, "out of bounds"):
                call()

    def test_wrong_shapes(self):
        positions, faces = cube()
        atlas = xatlas.Atlas()
        one = np.random.rand(1)
        for mesh in ((one, faces), (positions, one), (positions, faces, one)):
            with self.assertRaisesRegex(ValueError, "Nx3"):
                atlas.add_mesh(*mesh)
        with self.assertRaisesRegex(ValueError, "Nx2"):
            atlas.add_mesh(positions, faces, positions, one)
        with self.assertRaisesRegex(ValueError, "first dimension"):
            atlas.add_mesh(positions, faces, np.random.rand(1, 3))
        with self.assertRaisesRegex(RuntimeError, "out of range"):
            atlas.add_mesh(np.random.rand(1, 3), faces)
