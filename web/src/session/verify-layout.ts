import type { Abflat, MeshInput, VerifyOptions, VerifyReport, VerifyRule } from 'abflat';
import { copied } from '../base/buffers';
import { cornerUv } from '../model/arrangeable';
import type { Flattened, Outcome } from '../model/model';
import { isAsInFile } from '../model/settings';

export type Verifiable = Exclude<Outcome, Flattened>;

/** What was found in a layout. */
export interface Verified {
  report: VerifyReport;
  /** For each finding in turn, the islands as the page numbers them, and triangles of its faces. */
  marks: { islands: number[]; triangles: number[] }[];
}

/** A face without texcoords has none, and neither has one without area that touches no other. */
const NONE = 2 ** 32 - 1;
const isIsland = (island: number | undefined) => island !== undefined && island < NONE;

/** Rules whose findings are about whole islands; the faces only tell which. */
const OF_ISLANDS: ReadonlySet<VerifyRule> = new Set(['margin', 'thin', 'stretch']);

type Watch = Pick<VerifyOptions, 'signal' | 'onProgress'>;

/** Judges the layout on screen. `input`: the mesh that it is of, as it was opened. */
export async function verifyLayout(
  abflat: Abflat,
  input: MeshInput,
  outcome: Verifiable,
  rules: VerifyOptions,
  watch: Watch,
): Promise<Verified> {
  const { report, islandOfFace, faces } = await abflat.verify(
    await copied(meshOf(outcome, input)),
    {
      ...rules,
      udim: tilesOf(outcome) > 1,
      ...(usesFile(outcome) ? {} : { uv: uvOf(outcome) }),
      transfer: true,
      ...watch,
    },
  );
  const trianglesOf = byFace(faces, islandOfFace.length);
  const islandOn = islandsOnPage(outcome, faces, islandOfFace);
  const marks = report.findings.map((found) => ({
    islands: [...new Set(found.islands.map((island) => islandOn[island]))].filter(isIsland),
    triangles: OF_ISLANDS.has(found.rule) ? [] : found.faces.flatMap(trianglesOf),
  }));
  return { report, marks };
}

/** Texcoords of the file count as they are there, not as they are drawn. */
const usesFile = (outcome: Verifiable) => outcome.mode === 'pack' && isAsInFile(outcome.settings);

/** A document is given as arrays. */
function meshOf({ mesh, gltf, mode }: Verifiable, input: MeshInput): MeshInput {
  if (mode === 'pack') return gltf?.mesh ?? input;
  if ('bytes' in input) return input;
  return { positions: mesh.positions, indices: mesh.indices };
}

function tilesOf(outcome: Verifiable): number {
  return outcome.mode === 'pack' ? outcome.result.report.tiles : outcome.result.report.atlas.tiles;
}

/** 2 per corner of the input's triangles; NaN where the file has no texcoords. */
function uvOf(outcome: Verifiable): Float64Array {
  const uv = cornerUv(outcome.result);
  if (outcome.mode === 'unwrap') return uv;
  outcome.result.islandOfTriangle.forEach((island, t) => {
    if (island >= outcome.result.report.islands) uv.fill(Number.NaN, 6 * t, 6 * t + 6);
  });
  return uv;
}

/** The triangles of a face, which follow each other. */
function byFace(faces: Uint32Array, count: number): (face: number) => number[] {
  const first = new Uint32Array(count + 1);
  for (const face of faces) ++first[face + 1];
  for (let f = 0; f < count; ++f) first[f + 1] += first[f];
  return (face) => Array.from({ length: first[face + 1] - first[face] }, (_, i) => first[face] + i);
}

/** The number on the page of each island. */
function islandsOnPage(
  outcome: Verifiable,
  faces: Uint32Array,
  islandOfFace: Uint32Array,
): number[] {
  const of =
    outcome.mode === 'pack' ? outcome.result.islandOfTriangle : outcome.result.chartOfTriangle;
  const numbers: number[] = [];
  faces.forEach((face, t) => {
    if (islandOfFace[face] < NONE) numbers[islandOfFace[face]] ??= of[t];
  });
  return numbers;
}
