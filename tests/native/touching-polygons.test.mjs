// Polygons that touch themselves, judged from the numbers that are written: each corner has a
// texcoord in the chart of its face, and however a reader triangulates, no face overlaps another.
// ABFLAT_POLYGON_MESHES=340 ABFLAT_POLYGON_SEED=1000 makes more meshes, of three polygons each.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import {
  cutPolygon,
  flatness,
  isThinInSpace,
  judge,
  judgeFile,
  readAtlas,
  turn,
} from '../support/exact-atlas.mjs';
import { surfaceText } from '../support/random-surfaces.mjs';
import { isInstrumented, runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { EXTENT, touchingPolygons } from '../support/touching-polygons.mjs';

const MESHES = Number(process.env.ABFLAT_POLYGON_MESHES ?? (isInstrumented ? 8 : 60));
const FIRST = Number(process.env.ABFLAT_POLYGON_SEED ?? 0);

const isSame = (p, q) => p[0] === q[0] && p[1] === q[1];

/** The fan from the first corner, if it covers the polygon in its plane; otherwise nothing. */
function fanOf(points) {
  const out = points.slice(2).map((_, k) => [0, k + 1, k + 2]);
  return out.every((t) => turn(...t.map((k) => points[k])) >= 0) ? out : [];
}

/** Ears of the polygon in its plane, if they can be told there; otherwise nothing. */
function earsOf(points) {
  const { triangles, isCut } = cutPolygon(points);
  const isProper = isCut && triangles.every((t) => turn(...t.map((k) => points[k])) > 0);
  return isProper ? triangles : [];
}

/** The similarity that takes points closest to others, as a function. */
function similarity(from, to) {
  const mean = (list) => [0, 1].map((d) => list.reduce((s, p) => s + p[d], 0) / list.length);
  const [m, n] = [mean(from), mean(to)];
  const [re, im, sum] = from.reduce(
    ([a, b, s], p, i) => {
      const [x, y, u, v] = [p[0] - m[0], p[1] - m[1], to[i][0] - n[0], to[i][1] - n[1]];
      return [a + x * u + y * v, b + x * v - y * u, s + x * x + y * y];
    },
    [0, 0, 0],
  );
  return (p) => [
    n[0] + (re * (p[0] - m[0]) - im * (p[1] - m[1])) / sum,
    n[1] + (im * (p[0] - m[0]) + re * (p[1] - m[1])) / sum,
  ];
}

/** Triangles of a file's faces, except one, as a reader cuts them in uv. */
function trianglesOfOthers(faces, f) {
  return faces.flatMap((face, i) => {
    const points = face.map(({ uv }) => uv);
    return i === f ? [] : cutPolygon(points).triangles.map((t) => t.map((k) => points[k]));
  });
}

/** The Beltrami coefficient of a triangle's map from the plane to uv: above 1 if it turns over. */
function beltrami(plane, uv) {
  const side = (points, k) => [0, 1].map((d) => points[k][d] - points[0][d]);
  const [[a, b], [c, d]] = [side(plane, 1), side(plane, 2)];
  const [[p, q], [r, s]] = [side(uv, 1), side(uv, 2)];
  const [ux, uy] = [p * d - r * b, r * a - p * c];
  const [vx, vy] = [q * d - s * b, s * a - q * c];
  return Math.hypot(ux - vy, vx + uy) / Math.hypot(ux + vy, vx - uy);
}

/**
 * How much a face is bent where it is so most. Two triangles that meet in a corner change its angle
 * by 4 of that at most, and an ear of height f, in parts of its longest side, is 4 f short of
 * straight.
 */
function bendOf(points, face) {
  const { triangles } = cutPolygon(face.map(({ uv }) => uv));
  const bends = triangles.map((t) =>
    beltrami(
      t.map((k) => points[k]),
      t.map((k) => face[k].uv),
    ),
  );
  return Math.max(0, ...bends.filter((bend) => bend < 1));
}

/**
 * A reader's triangles of a polygon are not flipped and do not reach into another face. Only an ear
 * that is flatter on the surface than its face is bent may turn over, and lie on its neighbour.
 */
function checkReader(triangles, face, { others, bend }, run) {
  const uvOf = (t) => t.map((k) => face[k].uv);
  const inSpace = (t) => t.map((k) => face[k]);
  const isTurned = (t) => turn(...uvOf(t)) < 0;
  const flat = triangles.filter((t) => isTurned(t) && flatness(inSpace(t)) <= bend);
  const own = triangles.filter((t) => !flat.includes(t) || isThinInSpace(inSpace(t)));
  const flipped = own.filter((t) => isTurned(t) && !isThinInSpace(inSpace(t)));
  assert.deepEqual(flipped, [], `${run}: triangles that are flipped`);
  const isBesideFlat = (t) => flat.some((ear) => ear.filter((k) => t.includes(k)).length === 2);
  const inUv = own.map((t) => (isTurned(t) ? uvOf(t).toReversed() : uvOf(t)));
  const { overlaps } = judge([...inUv, ...others], { mayBeFlat: () => true, most: 1e4 });
  const across = overlaps.filter(
    ([a, b]) => a < own.length && b >= own.length && !isBesideFlat(own[a]),
  );
  assert.deepEqual(across, [], `${run}: triangles that reach into other faces`);
}

/** Spikes outside end where they begin; those inside end where their vertex lies in the face. */
function checkSpikes({ points, walk, rings, spikes, isAlone }, face, run) {
  const uv = new Map(walk.map((v, i) => [v, face[i].uv]));
  for (const { tip, isInside } of spikes) {
    const i = walk.indexOf(tip);
    const bases = [i - 1, i + 1].map((k) => face.at(k % face.length).uv);
    if (!isInside && isSame(...bases))
      assert.ok(isSame(bases[0], uv.get(tip)), `${run}: the spike at corner ${i}`);
  }
  if (!isAlone) return;
  const outline = rings[0].corners;
  const wanted = similarity(
    outline.map((v) => points[v]),
    outline.map((v) => uv.get(v)),
  );
  const scale = Math.hypot(...[0, 1].map((d) => wanted([1, 0])[d] - wanted([0, 0])[d]));
  const ends = spikes.filter((s) => s.isInside && outline.includes(s.base)).map((s) => s.tip);
  for (const v of [...outline, ...ends]) {
    const [p, q] = [wanted(points[v]), uv.get(v)];
    const off = Math.hypot(p[0] - q[0], p[1] - q[1]) / scale;
    assert.ok(off < 0.005 * EXTENT, `${run}: vertex ${v} of the polygon is off by ${off}`);
  }
}

function checkPolygons(mesh, path, run) {
  const { faces } = readAtlas(path);
  assert.equal(faces.length, mesh.faces.length);
  for (const face of faces)
    for (const { uv } of face)
      assert.ok(
        uv?.every((x) => x >= 0 && x <= 1),
        `${run}: texcoord ${uv}`,
      );
  for (const polygon of mesh.polygons) {
    const face = faces[polygon.face];
    const points = polygon.walk.map((v) => polygon.points[v]);
    const others = trianglesOfOthers(faces, polygon.face);
    const name = `${run}, face ${polygon.face}`;
    const bend = bendOf(points, face);
    checkReader(fanOf(points), face, { others, bend }, `${name}, fan`);
    checkReader(earsOf(points), face, { others, bend }, `${name}, ears`);
    checkSpikes(polygon, face, name);
  }
}

for (let seed = FIRST; seed < FIRST + MESHES; seed++)
  test(`polygons that touch themselves ${seed}`, async (t) => {
    const at = tempFolder(t);
    const mesh = touchingPolygons(seed);
    writeFileSync(at('in.obj'), surfaceText(mesh));
    for (const output of ['out.obj', 'out.glb']) {
      const args = ['unwrap', 'in.obj', '-o', output, '--report', 'r.json', '-q'];
      const { code, stderr } = await runAbflat(args, { cwd: at() });
      assert.equal(code, 0, stderr);
      const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
      assert.ok(report.valid && report.charts.every(({ valid }) => valid));
      const { isValid, ...judged } = judgeFile(at(output));
      assert.ok(isValid, `${output}: ${JSON.stringify(judged)}`);
    }
    checkPolygons(mesh, at('out.obj'), 'out.obj');
  });
