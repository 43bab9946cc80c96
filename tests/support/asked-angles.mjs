// Disks with straight runs and bounds of their boundary, each determined by its number, and what
// the boundary's angles are in a file. Nothing here uses the program's code.

import { generatedDisk } from './disks.mjs';
import { angleBetween, isThinInSpace, judge, readAtlas } from './exact-atlas.mjs';
import { Random } from './random-surfaces.mjs';

/** A polygon cut into triangles by chords, at random heights: all of its vertices are on the boundary. */
function cutPolygon(random) {
  const n = 5 + random.below(20);
  const height = random.pick([0.05, 0.5, 3]);
  const positions = Array.from({ length: n }, (_, i) => {
    const angle = (2 * Math.PI * i) / n;
    return [Math.cos(angle), Math.sin(angle), height * random.between(-1, 1)];
  });
  const left = positions.map((_, i) => i);
  const faces = [];
  const isFan = random.chance(0.5);
  while (left.length > 3) {
    const k = isFan ? 1 : random.below(left.length);
    faces.push([left.at(k - 1), left[k], left[(k + 1) % left.length]]);
    left.splice(k, 1);
  }
  return { positions, faces: [...faces, left] };
}

const edgesOf = (face) => face.map((v, k) => [v, face[(k + 1) % face.length]]);

/** The vertices of the only boundary, with the surface on the left. */
export function boundaryLoop(faces) {
  const inner = new Set(faces.flatMap(edgesOf).map(([a, b]) => `${b} ${a}`));
  const next = new Map(faces.flatMap(edgesOf).filter(([a, b]) => !inner.has(`${a} ${b}`)));
  const [first] = next.keys();
  const loop = [first];
  for (let v = next.get(first); v !== first; v = next.get(v)) loop.push(v);
  return loop;
}

/** Runs from place to place of the boundary, at random, of any length. */
function randomRuns(random, n) {
  const count = 1 + random.below(4);
  const most = random.pick([2, 5, n]);
  return Array.from({ length: count }, () => {
    const from = random.below(n);
    return { from, to: (from + 1 + random.below(Math.min(most, n - 1))) % n };
  });
}

/** Places strictly within the runs. */
function straightPlaces(runs, n) {
  const out = new Set();
  for (const { from, to } of runs)
    for (let i = (from + 1) % n; i !== to; i = (i + 1) % n) out.add(i);
  return out;
}

/** Whether an inner edge joins two places with only straight places between them. */
function cutsOffRun(faces, loop, straight) {
  const place = new Map(loop.map((v, i) => [v, i]));
  const n = loop.length;
  return faces.flatMap(edgesOf).some(([a, b]) => {
    const [from, to] = [place.get(a), place.get(b)];
    if (from === undefined || to === undefined) return false;
    const isRun = (i, end) => {
      const first = (i + 1) % n;
      if (first === end) return false;
      for (let k = first; k !== end; k = (k + 1) % n) if (!straight.has(k)) return false;
      return true;
    };
    return isRun(from, to) || isRun(to, from);
  });
}

/**
 * Disk number n with wishes: { positions, faces, loop, runs, straight, isFeasible }, where places
 * count along the loop.
 */
export function straightDisk(seed) {
  const random = new Random(seed);
  const mesh = random.chance(0.5) ? cutPolygon(random) : generatedDisk(random.below(1e6), 400);
  const loop = boundaryLoop(mesh.faces);
  const n = loop.length;
  const isAnyWanted = random.chance(0.1);
  for (;;) {
    const runs = randomRuns(random, n);
    const straight = straightPlaces(runs, n);
    const isFeasible = straight.size + 3 <= n && !cutsOffRun(mesh.faces, loop, straight);
    // A triangle has no place that could be straight.
    if (isFeasible || isAnyWanted || n < 4) return { ...mesh, loop, runs, straight, isFeasible };
  }
}

/** The texcoord of each vertex of a mesh with one texcoord per vertex, from its file. */
export function vertexTexcoords({ positions, faces }, path) {
  const atlas = readAtlas(path);
  const out = new Array(positions.length);
  for (const [f, face] of atlas.faces.entries())
    for (const [k, { uv }] of face.entries()) out[faces[f][k]] = uv;
  return out;
}

/** The interior angle at each place of the boundary. */
export const boundaryAngles = (loop, uv) =>
  loop.map((v, i) => angleBetween(uv[loop[(i + 1) % loop.length]], uv[v], uv[loop.at(i - 1)]));

/** Whether the layout in a file has flipped or overlapping triangles, or some without area. */
export function isInjective({ positions, faces }, uv) {
  const mayBeFlat = (f) => isThinInSpace(faces[f].map((v) => ({ place: positions[v] })));
  const triangles = faces.map((face) => face.map((v) => uv[v]));
  const { flipped, flat, overlaps } = judge(triangles, { mayBeFlat, most: 1 });
  return flipped.length + flat.length + overlaps.length === 0;
}
