"""Layouts of abflat.unwrap, flatten and pack, judged by their arrays."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import abflat
from judge import areas, faults
from meshes import QUADS, cube, hill, soup, torus


def write_obj(path, positions, faces):
    lines = [f"v {x!r} {y!r} {z!r}\n" for x, y, z in positions.tolist()]
    lines += ["f " + " ".join(str(v + 1) for v in face) + "\n" for face in faces]
    Path(path).write_text("".join(lines))


def by_program(positions, faces, *options):
    """The uv of every corner of a face, from the file that the program writes."""
    with tempfile.TemporaryDirectory() as folder:
        write_obj(f"{folder}/in.obj", positions, faces)
        files = [f"{folder}/in.obj", "-o", f"{folder}/out.obj"]
        command = [os.environ["ABFLAT_BIN"], "unwrap", *files, *options]
        subprocess.run(command, check=True, capture_output=True)
        words = [line.split() for line in Path(f"{folder}/out.obj").read_text().splitlines()]
    uv = np.array([[float(x) for x in w[1:]] for w in words if w[:1] == ["vt"]])
    corners = [[int(c.split("/")[1]) - 1 for c in w[1:]] for w in words if w[:1] == ["f"]]
    return uv[np.array(corners)]


class Unwrap(unittest.TestCase):
    def check(self, result, positions, triangles):
        self.assertTrue(result.valid, result.report["notes"])
        self.assertEqual(faults(result.uv, result.triangles), ([], []))
        self.assertTrue((result.uv >= 0).all() and (result.uv <= 1).all())
        np.testing.assert_array_equal(result.vertex_map[result.triangles], triangles)
        np.testing.assert_array_equal(np.unique(result.vertex_map), np.arange(len(positions)))
        self.assertTrue((np.diff(result.vertex_map.astype(int)) >= 0).all())

    def test_layouts_are_valid_and_faces_keep_their_order(self):
        for mesh in (cube(), torus(), hill()):
            self.check(abflat.unwrap(*mesh), *mesh)

    def test_the_result_is_that_of_the_program(self):
        positions, triangles = torus()
        for values, flags in (
            ({}, ()),
            ({"max_stretch": 1.2, "padding": 7}, ("--max-stretch", "1.2", "--padding", "7")),
            ({"straight_seams": True, "rotate": "none"}, ("--straight-seams", "--rotate", "none")),
            ({"seams": "auto,sharp=30"}, ("--seams", "auto,sharp=30")),
        ):
            result = abflat.unwrap(positions, triangles, **values)
            expected = by_program(positions, triangles, *flags)
            np.testing.assert_array_equal(result.uv[result.faces], expected, str(values))

    def test_charts_and_seams(self):
        positions, triangles = torus()
        result = abflat.unwrap(positions, triangles)
        self.assertEqual(
            set(result.chart_of_triangle.tolist()), set(range(len(result.report["charts"])))
        )
        np.testing.assert_array_equal(result.chart_of_face, result.chart_of_triangle)
        edges = {frozenset(e) for t in triangles.tolist() for e in zip(t, t[1:] + t[:1])}
        self.assertLessEqual({frozenset(e) for e in result.seams.tolist()}, edges)
        self.assertGreater(len(result.seams), 0)

    def test_given_seams_are_cut(self):
        positions, triangles = hill()
        path = [[4 + 9 * j, 4 + 9 * (j + 1)] for j in range(3)]
        result = abflat.unwrap(positions, triangles, seam_edges=path)
        cut = {frozenset(e) for e in result.seams.tolist()}
        self.assertLessEqual({frozenset(e) for e in path}, cut)

    def test_seams_of_a_layout_and_between_materials(self):
        positions, triangles = hill()
        flat = abflat.flatten(positions, triangles)
        halves = np.where(positions[triangles][:, :, 0].mean(axis=1) < 4, "left", "right")
        uv_faces = np.where((halves == "left")[:, None], triangles, triangles + len(positions))
        uv = np.concatenate([flat.uv, flat.uv + 100])
        border = {frozenset([4 + 9 * j, 4 + 9 * (j + 1)]) for j in range(8)}
        for values in (
            {"seams": "uv", "uv": uv, "uv_faces": uv_faces},
            {"seams": "material", "materials": halves},
        ):
            result = abflat.unwrap(positions, triangles, **values)
            self.assertEqual({frozenset(e) for e in result.seams.tolist()}, border)
            self.assertEqual(len(result.report["charts"]), 2)

    def test_objects_are_apart_where_they_touch(self):
        positions, triangles = hill()
        scene = np.concatenate([positions, positions]), np.concatenate(
            [triangles, triangles[:, ::-1] + len(positions)]
        )
        objects = np.repeat(["front", "back"], len(positions))
        result = abflat.unwrap(*scene, vertex_objects=objects)
        self.assertTrue(result.valid)
        self.assertEqual(result.report["repair"]["mergedVertices"], 0)
        front, back = np.split(result.chart_of_triangle, 2)
        self.assertFalse(set(front) & set(back))

    def test_pins_hold_their_places(self):
        positions, triangles = hill()
        pins = [[0, 0.25, 0.25], [8, 0.75, 0.25]]
        result = abflat.unwrap(positions, triangles, max_stretch=10, pins=pins)
        for vertex, u, v in pins:
            np.testing.assert_allclose(result.uv[vertex], [u, v], atol=1e-12)

    def test_densities_make_faces_larger(self):
        positions, triangles = cube()
        two = np.concatenate([positions, positions + 5]), np.concatenate([triangles, triangles + 8])
        densities = np.repeat([1.0, 3.0], 12)
        result = abflat.unwrap(*two, face_densities=densities)
        sizes = areas(result.uv, result.triangles)
        np.testing.assert_allclose(sizes[12:].sum() / sizes[:12].sum(), 9, rtol=1e-6)

    def test_single_precision_is_exact_in_float32(self):
        positions, triangles = torus()
        result = abflat.unwrap(positions, triangles, precision="single")
        rounded = result.uv.astype(np.float32)
        np.testing.assert_array_equal(rounded, result.uv)
        self.assertEqual(faults(rounded, result.triangles), ([], []))

    def test_polygons(self):
        positions, _ = cube()
        for faces in (QUADS, np.array(QUADS, np.int16), [*QUADS[:5], [3, 0, 4], [3, 4, 7]]):
            result = abflat.unwrap(positions, faces)
            self.assertTrue(result.valid)
            for face, given in zip(result.faces, faces):
                np.testing.assert_array_equal(result.vertex_map[face], given)
        self.assertIsInstance(result.faces, list)

    def test_soups_are_valid(self):
        for seed in range(3):
            positions, triangles = soup(seed)
            result = abflat.unwrap(positions, triangles)
            np.testing.assert_array_equal(result.vertex_map[result.triangles], triangles)
            proper = [len(set(t)) == 3 for t in triangles.tolist()]
            self.assertTrue(result.valid)
            self.assertEqual(faults(result.uv, result.triangles[proper]), ([], []))

    def test_an_empty_mesh_is_an_error(self):
        for faces in ([], np.empty((0, 3), np.int64)):
            with self.assertRaises(abflat.AbflatError) as caught:
                abflat.unwrap(cube()[0], faces)
            self.assertEqual(caught.exception.code, "EmptyMesh")


class Flatten(unittest.TestCase):
    def test_a_disk_lies_flat(self):
        positions, triangles = hill()
        result = abflat.flatten(positions, triangles, t=1.0)
        self.assertTrue(result.valid)
        self.assertEqual(faults(result.uv, result.triangles), ([], []))
        self.assertEqual(result.report["options"]["t"], 1)
        np.testing.assert_array_equal(result.vertex_map[result.faces], triangles)

    def test_pins_bounds_and_straight_runs_arrive(self):
        positions, triangles = hill()
        pins = [[0, 0.0, 0.0], [8, 5.0, 0.0]]
        result = abflat.flatten(positions, triangles, straight=[[0, 8]], pins=pins)
        np.testing.assert_allclose(result.uv[:9, 1], 0, atol=1e-6)
        bounded = abflat.flatten(positions, triangles, bounds=[[4, 0.8]])
        a, o, b = bounded.uv[[5, 4, 3]]
        sides = a - o, b - o
        angle = np.arccos(np.dot(*sides) / np.prod([np.linalg.norm(s) for s in sides]))
        self.assertLessEqual(angle, 0.8 * np.pi + 1e-6)

    def test_what_is_no_disk_is_refused(self):
        for mesh, code in ((cube(), "ClosedSurface"), (soup(1), None)):
            with self.assertRaises(abflat.AbflatError) as caught:
                abflat.flatten(*mesh)
            if code:
                self.assertEqual(caught.exception.code, code)


class Pack(unittest.TestCase):
    def test_one_uv_per_vertex_and_none(self):
        positions, triangles = hill()
        uv = abflat.flatten(positions, triangles).uv
        uv[0] = np.nan
        result = abflat.pack(positions, triangles, uv)
        without = (triangles == 0).any(axis=1)
        np.testing.assert_array_equal(result.island_of_triangle < 0, without)
        self.assertEqual(faults(result.uv, result.triangles[~without]), ([], []))

    def test_islands_keep_their_shapes(self):
        positions, triangles = torus()
        first = abflat.unwrap(positions, triangles)
        result = abflat.pack(positions, triangles, first.uv, first.triangles, padding=20)
        self.assertTrue(result.valid)
        self.assertEqual(faults(result.uv, result.triangles), ([], []))
        np.testing.assert_array_equal(result.vertex_map[result.triangles], triangles)

        def sides(uv):
            a, b, c = np.moveaxis(uv, 1, 0)
            return np.linalg.norm(np.stack([b - a, c - b, a - c]), axis=2)

        ratio = sides(result.uv[result.triangles]) / sides(first.uv[first.triangles])
        np.testing.assert_allclose(ratio, ratio[0, 0], rtol=1e-6)
