"""What abflat.verify finds in layouts."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import abflat
from meshes import QUADS, cube, torus

SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)


def squares(corners):
    """Quads that do not touch, each as large as in uv: ``(u, v, side)``."""
    uv = np.concatenate([SQUARE * side + (u, v) for u, v, side in corners])
    sides = np.concatenate([SQUARE * side for _, _, side in corners])
    positions = np.column_stack([sides, np.repeat(np.arange(len(corners)), 4)])
    return positions, np.arange(4 * len(corners)).reshape(-1, 4), uv


OVERLAPPING = squares([(0.1, 0.1, 0.3), (0.2, 0.2, 0.3)])
APART = squares([(0.1, 0.1, 0.3), (0.5, 0.1, 0.3)])


def rules_of(result):
    return [found["rule"] for found in result.findings]


class Verify(unittest.TestCase):
    def test_findings_name_faces_and_islands(self):
        result = abflat.verify(*OVERLAPPING)
        self.assertFalse(result.valid)
        (found,) = result.findings
        self.assertEqual(found["rule"], "overlapBetween")
        self.assertEqual((found["faces"], found["islands"]), ([0, 1], [0, 1]))
        self.assertEqual(result.island_of_face.tolist(), [0, 1])
        self.assertEqual(result.face_of_triangle.tolist(), [0, 0, 1, 1])
        self.assertTrue((result.faults & abflat.UV_FAULT["overlapping"]).any())
        self.assertEqual(repr(result), "<VerifyResult: 2 islands, 1 finding>")

    def test_rules_are_options(self):
        self.assertTrue(abflat.verify(*APART).valid)
        self.assertEqual(repr(abflat.verify(*APART)), "<VerifyResult: 2 islands, valid>")
        for options, rules in (
            ({"padding": 99}, []),
            ({"padding": 101}, ["padding"]),
            ({"max_islands": 1}, ["islands"]),
            ({"min_utilization": 0.5, "min_island_width": 301}, ["thin", "thin", "utilization"]),
            ({"max_stretch": "none"}, []),
        ):
            result = abflat.verify(*APART, resolution=1000, **options)
            self.assertEqual(rules_of(result), rules, str(options))
        self.assertTrue(abflat.verify(*OVERLAPPING, allow_overlaps=True).valid)

    def test_faces_without_uv_have_no_island(self):
        positions, faces, uv = APART
        uv = np.where(np.arange(8)[:, None] < 4, uv, np.nan)
        result = abflat.verify(positions, faces, uv)
        self.assertEqual(result.island_of_face.tolist(), [0, -1])
        self.assertEqual(rules_of(result), ["unmapped"])
        self.assertTrue(abflat.verify(positions, faces, uv, allow_unmapped=True).valid)

    def test_what_unwrap_makes_is_valid(self):
        for positions, faces in (cube(), torus()):
            made = abflat.unwrap(positions, faces, padding=6)
            used = made.vertex_map[made.triangles]
            result = abflat.verify(positions, used, made.uv, made.triangles, padding=6)
            self.assertTrue(result.valid, result.findings)
            self.assertEqual(result.report["islands"], len(made.report["charts"]))

    def test_the_report_is_that_of_the_program(self):
        positions, faces, uv = OVERLAPPING
        with tempfile.TemporaryDirectory() as folder:
            lines = [f"v {x!r} {y!r} {z!r}\n" for x, y, z in positions.tolist()]
            lines += [f"vt {u!r} {v!r}\n" for u, v in uv.tolist()]
            lines += ["f " + " ".join(f"{c + 1}/{c + 1}" for c in face) + "\n" for face in faces]
            Path(folder, "in.obj").write_text("".join(lines))
            command = [os.environ["ABFLAT_BIN"], "verify", "in.obj", "--padding", "3", "-q"]
            ended = subprocess.run([*command, "--report", "r.json"], cwd=folder, check=False)
            expected = json.loads(Path(folder, "r.json").read_text())
        self.assertEqual(ended.returncode, 1)
        found = abflat.verify(positions, faces, uv, padding=3).report
        for key in expected.keys() - {"input", "timings"}:
            self.assertEqual(found[key], expected[key], key)

    def test_wrong_arguments_are_refused(self):
        positions, _ = cube()
        with self.assertRaisesRegex(TypeError, "no option 'pading'; did you mean 'padding'"):
            abflat.verify(*APART, pading=3)
        with self.assertRaisesRegex(abflat.AbflatError, "padding cannot be -1"):
            abflat.verify(*APART, padding=-1)
        with self.assertRaisesRegex(abflat.AbflatError, r"uv has the shape \(8,\)"):
            abflat.verify(positions, QUADS, np.zeros(8))
        with self.assertRaisesRegex(abflat.AbflatError, "no face has texcoords"):
            abflat.verify(positions, QUADS, np.full((8, 2), np.nan))

    def test_progress_ends_a_run(self):
        stages = []
        abflat.verify(*APART, progress=lambda stage, _: stages.append(stage))
        self.assertEqual(set(stages), {"check"})

        def stop(*_):
            raise KeyError("enough")

        with self.assertRaisesRegex(KeyError, "enough"):
            abflat.verify(*APART, progress=stop)


if __name__ == "__main__":
    unittest.main()
