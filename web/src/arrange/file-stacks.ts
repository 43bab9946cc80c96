import { UV_FAULT } from 'abflat';
import { STACKED } from '../colors/fault-colors';
import type { FileStacks, Stack } from '../model/stacks';
import { type Box, boxOf, type ChartArrays, pointOf, trianglesOf } from './charts';
import { grouped, outlineOf } from './stacks';

/** Digits of uv that count: less than a texel. */
const DIGITS = 4;

/**
 * The islands of a file that share their texels on purpose: they lie on each other with the same
 * outline, mirrored or not, and on nothing else. What overlaps in them is marked as stacked.
 * `faces`: the face of each triangle, if that is not the triangle itself.
 */
export function fileStacks(
  arrays: ChartArrays,
  faults: Uint8Array,
  faces?: Uint32Array,
): FileStacks {
  const { uv, indices, chartOfTriangle } = arrays;
  const overlapping = chartOfTriangle.filter((_, f) => faults[f] & UV_FAULT.overlapping);
  const triangles = trianglesOf(chartOfTriangle, Uint32Array.from(new Set(overlapping)));
  const cornersOf = (f: number) => [...indices.subarray(3 * f, 3 * f + 3)];
  const boxes = new Map(
    [...triangles].map(([island, own]) => [island, boxOf(uv, own.flatMap(cornersOf))]),
  );
  const stacks = grouped(boxes.keys(), (island) => nameOf(boxes.get(island)))
    .flatMap((some) => grouped(some, (island) => outlineName(arrays, triangles.get(island) ?? [])))
    .filter((stack) => isAlone(stack, boxes));
  const marked = faults.slice();
  for (const f of stacks.flat().flatMap((island) => triangles.get(island) ?? []))
    if (marked[f] & UV_FAULT.overlapping) marked[f] += STACKED - UV_FAULT.overlapping;
  return { stacks, faults: marked, faces: countFaces(marked, faces) };
}

const placeOf = (numbers: number[]) => numbers.map((x) => x.toFixed(DIGITS)).join();

const nameOf = (box?: Box) => (box ? placeOf([...box.low, ...box.high]) : '');

/** The same for both directions. */
function outlineName(arrays: ChartArrays, triangles: number[]): string {
  const ends = (edge: readonly number[]) => edge.map((v) => placeOf(pointOf(arrays.uv, v)));
  return outlineOf(arrays, triangles)
    .map((edge) => ends(edge).sort().join(' '))
    .sort()
    .join();
}

/** Whether no other island that overlaps something is near. */
function isAlone(stack: Stack, boxes: Map<number, Box>): boolean {
  const own = boxes.get(stack[0]);
  return [...boxes].every(([island, box]) => stack.includes(island) || !own || !meet(own, box));
}

const meet = (a: Box, b: Box) => [0, 1].every((d) => a.low[d] < b.high[d] && b.low[d] < a.high[d]);

/** Faces with a stacked triangle; triangles of a face follow each other. */
function countFaces(faults: Uint8Array, faces?: Uint32Array): number {
  let [count, last] = [0, -1];
  faults.forEach((bits, f) => {
    const face = faces ? faces[f] : f;
    if (!(bits & STACKED) || face === last) return;
    last = face;
    ++count;
  });
  return count;
}
