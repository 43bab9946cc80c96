"""What may be given, and what is said about the rest."""

import json
import pickle
import unittest
from pathlib import Path

import numpy as np

import abflat
from abflat._mesh import mesh_of
from meshes import cube

SCHEMA = Path(__file__).parents[3] / "core/schema/abflat.json"


class Arrays(unittest.TestCase):
    def setUp(self):
        self.positions, self.triangles = cube()
        self.expected = abflat.unwrap(self.positions, self.triangles).uv

    def unwrap(self, *mesh):
        return np.array(abflat.unwrap(*mesh).uv)

    def test_every_type_of_number_gives_the_same(self):
        for kind in ("f4", "f8", ">f4", ">f8", "i4", "u1", "f2"):
            got = self.unwrap(self.positions.astype(kind), self.triangles)
            np.testing.assert_array_equal(got, self.expected, kind)
        for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", ">i4", ">u8"):
            got = self.unwrap(self.positions, self.triangles.astype(kind))
            np.testing.assert_array_equal(got, self.expected, kind)

    def test_every_layout_in_memory_gives_the_same(self):
        wide = np.full((8, 7), np.nan)
        wide[:, 2:5] = self.positions
        for points in (
            wide[:, 2:5],
            np.asfortranarray(self.positions),
            self.positions[::-1].copy()[::-1],
            self.positions.tolist(),
        ):
            np.testing.assert_array_equal(self.unwrap(points, self.triangles), self.expected)
        rows = np.repeat(self.triangles, 2, axis=0)[::2]
        for faces in (rows, np.asfortranarray(self.triangles), self.triangles.tolist()):
            np.testing.assert_array_equal(self.unwrap(self.positions, faces), self.expected)

    def test_what_can_be_read_where_it_is_is_not_copied(self):
        rows = np.zeros((8, 5))
        for points in (self.positions, self.positions.astype("f4"), rows[:, 1:4], rows[::2, :3]):
            self.assertTrue(np.shares_memory(mesh_of(points, self.triangles).positions, points))
        for kind in ("u2", "i4", "u4", "i8", "u8"):
            faces = np.ascontiguousarray(self.triangles, kind)
            self.assertTrue(np.shares_memory(mesh_of(self.positions, faces).vertices, faces), kind)

    def test_the_arrays_of_the_caller_do_not_change(self):
        points, faces = self.positions.copy(), self.triangles.copy()
        points.flags.writeable = faces.flags.writeable = False
        self.unwrap(points, faces)
        np.testing.assert_array_equal(points, self.positions)
        np.testing.assert_array_equal(faces, self.triangles)

    def test_an_object_with_vertices_and_faces(self):
        class Trimesh:
            vertices, faces = self.positions, self.triangles

        np.testing.assert_array_equal(self.unwrap(Trimesh()), self.expected)
        with self.assertRaisesRegex(TypeError, "positions and faces"):
            abflat.unwrap(self.positions)

    def test_results_outlive_the_call_and_can_be_written_to(self):
        uv = abflat.unwrap(self.positions, self.triangles).uv
        uv += 0
        np.testing.assert_array_equal(uv, self.expected)

    def test_what_is_no_mesh_is_named(self):
        nan = self.positions.copy()
        nan[3, 1] = np.nan
        huge = self.triangles.astype(np.int64) + 2**32
        for positions, faces, words in (
            (self.positions[:, :2], self.triangles, r"positions have the shape \(8, 2\)"),
            (self.positions.astype(str), self.triangles, "positions are of type"),
            (self.positions, self.triangles.astype(float), "faces are of type float64"),
            (self.positions, self.triangles.reshape(-1), r"faces have the shape \(36,\)"),
            (self.positions, self.triangles + 1, "face 4 refers to vertex 8"),
            (self.positions, self.triangles - 1, "face 0 refers to vertex -1"),
            (self.positions, huge, "refers to vertex 4294967"),
            (self.positions, np.hstack([huge, huge]), "refers to vertex 4294967"),
            (nan, self.triangles, "vertex 3"),
        ):
            with self.assertRaisesRegex(abflat.AbflatError, words) as caught:
                abflat.unwrap(positions, faces)
            self.assertEqual(caught.exception.code, "InvalidMesh")


class Options(unittest.TestCase):
    def test_every_option_of_the_schema_can_be_set_to_its_default(self):
        positions, triangles = cube()
        uv = positions[:, 1::-1]
        for options, call in (
            (abflat.UNWRAP_OPTIONS, lambda **o: abflat.unwrap(positions, triangles, **o)),
            (abflat.FLATTEN_OPTIONS, lambda **o: abflat.flatten(positions, triangles[:1], **o)),
            (abflat.PACK_OPTIONS, lambda **o: abflat.pack(positions, triangles[:1], uv, **o)),
            (abflat.VERIFY_OPTIONS, lambda **o: abflat.verify(positions, triangles[:1], uv, **o)),
        ):
            result = call(**{name: info.default for name, info in options.items()})
            for info in options.values():
                if info.name in result.report.get("options", {}):
                    self.assertEqual(result.report["options"][info.name], info.default, info.name)

    def test_values_arrive(self):
        values = {
            "max_stretch": 1.5,
            "fill_holes": "never",
            "t": 3,
            "orient": True,
            "padding": np.int64(5),
            "balance": np.float32(0.5),
            "udim": np.bool_(False),
        }
        report = abflat.unwrap(*cube(), **values).report
        for name, value in values.items():
            self.assertEqual(report["options"][abflat.UNWRAP_OPTIONS[name].name], value, name)

    def test_an_unknown_option_names_the_nearest(self):
        for name, nearest in (
            ("max_strech", "max_stretch"),
            ("maxStretch", "max_stretch"),
            ("seam", "seams"),
        ):
            with self.assertRaisesRegex(TypeError, f"{name}.*did you mean '{nearest}'"):
                abflat.unwrap(*cube(), **{name: 1})
        with self.assertRaisesRegex(TypeError, "no option 'xyz'$"):
            abflat.unwrap(*cube(), xyz=1)

    def test_a_bad_value_is_named_with_its_range(self):
        for name, value in (
            ("max_stretch", 1),
            ("max_stretch", "auto"),
            ("max_stretch", None),
            ("max_stretch", [2]),
            ("rotate", "sideways"),
            ("rotate", 0),
            ("udim", 1),
            ("padding", True),
            ("padding", 2.5),
            ("margin", -1),
            ("t", float("nan")),
            ("seams", "none of these"),
            ("precision", "half"),
            ("pins", [[0, 1]]),
            ("pins", [[99, 0, 0], [1, 0, 0]]),
            ("seam_edges", [[0, -1]]),
            ("face_densities", [1, 2]),
        ):
            with self.subTest(name=name, value=value):
                with self.assertRaises(abflat.AbflatError) as caught:
                    abflat.unwrap(*cube(), **{name: value})
                self.assertEqual(caught.exception.code, "InvalidOption")

    def test_a_layout_that_does_not_fit_the_mesh(self):
        positions, triangles = cube()
        uv = positions[:, :2]
        for values, words in (
            ({"uv": positions}, "uv has the shape"),
            ({"uv": uv[:7]}, "row 7 of uv; there are 7"),
            ({"uv": uv, "uv_faces": triangles[1:]}, "different numbers of corners"),
            ({"materials": [1, 2]}, r"materials have the shape \(2,\); it must be \(12,\)"),
            ({"vertex_objects": [1]}, r"vertex_objects have the shape \(1,\); it must be \(8,\)"),
        ):
            with self.assertRaisesRegex(abflat.AbflatError, words) as caught:
                abflat.unwrap(positions, triangles, **values)
            self.assertEqual(caught.exception.code, "InvalidMesh")
        with self.assertRaisesRegex(TypeError, "needs uv"):
            abflat.unwrap(positions, triangles, uv_faces=triangles)

    def test_the_table_is_that_of_the_schema(self):
        schema = json.loads(SCHEMA.read_text())
        given = schema["unwrapOptions"]
        names = [each if isinstance(each, str) else each["name"] for each in given]
        self.assertEqual([info.name for info in abflat.UNWRAP_OPTIONS.values()], names)


class Errors(unittest.TestCase):
    def test_an_error_can_be_sent_to_another_process(self):
        error = pickle.loads(pickle.dumps(abflat.AbflatError("EmptyMesh", "the mesh has no faces")))
        self.assertEqual((error.code, str(error)), ("EmptyMesh", "the mesh has no faces"))
