"""abflat.xatlas.PackOptions and ChartOptions."""

import unittest

import numpy as np

from abflat import xatlas
from judge import faults
from judged import Judged, generated, options
from meshes import cube, soup, torus


class Packed(Judged):
    def test_texels_per_unit(self):
        atlas = generated(cube(), texels_per_unit=100)
        self.assertEqual((atlas.texels_per_unit, atlas.atlas_count), (100, 1))
        self.check(atlas[0], *cube())
        several = generated(cube(), texels_per_unit=100, resolution=128)
        self.assertEqual((several.width, several.texels_per_unit), (128, 100))
        self.assertGreater(several.atlas_count, 1)
        _, indices, uvs = several[0]
        tiles, _ = several.get_mesh_vertex_assignment(0)
        self.assertEqual(set(tiles.tolist()), set(range(several.atlas_count)))
        for tile in range(several.atlas_count):
            own = indices[tiles[indices[:, 0]] == tile]
            self.assertEqual(faults(uvs, own), ([], []))
            self.assertGreater(several.get_utilization(tile), 0)

    def test_padding_is_kept_free(self):
        for padding, bilinear in ((0, False), (6, False), (6, True)):
            values = {"padding": padding, "bilinear": bilinear, "create_image": True}
            atlas = generated(cube(), torus(), resolution=256, **values)
            wanted = padding + 2 * bilinear
            image = atlas.chart_image
            self.assertEqual((image.shape, image.dtype), ((256, 256, 3), np.uint8))
            colors = image.astype(int) @ [1, 256, 65536]
            for shift in range(1, wanted + 1):
                for rows in (colors, colors.T):
                    a, b = rows[shift:], rows[:-shift]
                    self.assertFalse(((a != b) & (a > 0) & (b > 0)).any(), (padding, bilinear))

    def test_the_image_shows_the_charts(self):
        atlas = generated(torus(), resolution=256, create_image=True)
        share = (atlas.chart_image > 0).any(axis=2).mean()
        self.assertAlmostEqual(share, atlas.utilization, delta=0.01)
        with self.assertRaises(RuntimeError):
            generated(torus()).chart_image

    def test_charts_that_do_not_fit_get_a_larger_atlas(self):
        with self.assertWarnsRegex(RuntimeWarning, "larger than 16 texels"):
            atlas = generated(soup(1), resolution=16)
        self.assertGreater(atlas.width, 16)
        with self.assertWarnsRegex(RuntimeWarning, "texels_per_unit is lower"):
            atlas = generated(cube(), resolution=64, texels_per_unit=1000)
        self.assertEqual(atlas.width, 64)
        with self.assertWarnsRegex(RuntimeWarning, "resolution is 408, not 64"):
            atlas = generated(cube(), resolution=64, padding=100)
        self.check(atlas[0], *cube())
        with self.assertWarnsRegex(RuntimeWarning, "padding is 256, not 1000"):
            generated(cube(), padding=998)


class Options(unittest.TestCase):
    def test_names_of_c_plus_plus_and_of_python(self):
        made = xatlas.PackOptions()
        made.blockAlign = True
        made.texels_per_unit = 3
        self.assertEqual((made.block_align, made.texelsPerUnit), (True, 3))
        with self.assertRaises(AttributeError):
            made.paddding = 3
        with self.assertRaises(AttributeError):
            made.paddding
        self.assertEqual(xatlas.ChartOptions().maxCost, 2)

    def test_what_is_ignored_is_said(self):
        atlas = xatlas.Atlas()
        atlas.add_mesh(*cube())
        with self.assertWarnsRegex(UserWarning, "max_cost is ignored") as caught:
            atlas.generate(options(xatlas.ChartOptions, max_cost=8.0))
        self.assertEqual(caught.filename, __file__, "it names the caller's line")
        with self.assertWarnsRegex(UserWarning, "brute_force is ignored"):
            atlas.generate(pack_options=options(xatlas.PackOptions, bruteForce=True))
