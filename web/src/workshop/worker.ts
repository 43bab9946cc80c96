// The worker's side of workshop.ts: everything that loops over all triangles is done here, off the
// main thread.

import { expose, transfer } from 'comlink';
import type { ChartMesh } from '../arrange/chart-mesh';
import type { ChartArrays } from '../arrange/charts';
import type { SurfaceArrays as DensityArrays } from '../arrange/density';
import type { Flipped } from '../arrange/flip';
import type { Motions } from '../arrange/move-charts';
import { buffersOf } from '../base/buffers';
import { loadInWorker } from '../base/load-part';
import { exportedFile } from '../base/mesh-files';
import { startOnce } from '../base/start-once';
import { drawFlat } from '../drawing/draw';
import { drawMesh } from '../drawing/draw-mesh';
import {
  type AtlasArrays,
  type AtlasSize,
  atlasPicture,
  flatPicture,
  type MarkedChart,
  meshPicture,
} from '../drawing/picture';
import type { LookSource } from '../files/appearance';
import type { BakedGltf } from '../files/baked-gltf';
import { hasLook } from '../files/has-look';
import type { NamedMesh } from '../files/joined-obj';
import type { LookMesh } from '../files/stored-look';
import type { AtlasDrawing } from '../files/svg-text';
import type { ArrayMesh, DisplayMesh } from '../mesh/mesh';
import { type PlacedVertices, positionsOf } from '../mesh/positions-of';
import type { AppearanceRead } from '../model/appearance';
import type { Drawing, FlatDrawing } from '../model/drawing';
import type { FaceDensities } from '../model/face-densities';
import type { ChosenGltf, GltfFiles, LayoutArrays } from '../model/model';
import type { NamedParts } from '../model/named-parts';
import type { Stack, Stacks } from '../model/stacks';
import type { SurfaceArrays } from '../surface/make-surface';
import type { bake, bakeObj } from './baking';

// All but drawing is not part of the first load. What is loaded keeps the order of requests.
const gltfFile = startOnce(() => loadInWorker(import('../files/gltf-file')));
const newGlbFile = startOnce(() => loadInWorker(import('../files/new-glb')));
const objParts = startOnce(() => loadInWorker(import('../files/obj-parts')));
const joinedGltf = startOnce(() => loadInWorker(import('../files/joined-gltf')));
const appearanceFile = startOnce(() => loadInWorker(import('../files/appearance')));
const arranging = startOnce(() => loadInWorker(import('./arranging')));
const baking = startOnce(() => loadInWorker(import('./baking')));
const writing = startOnce(() => loadInWorker(import('./writing')));
const zip = startOnce(() => loadInWorker(import('../files/zip')));
const surfaces = startOnce(() => loadInWorker(import('../surface/make-surface')));

const LATER = [gltfFile, newGlbFile, appearanceFile, arranging, writing, surfaces, objParts];

/** The input of an atlas, and what the densities of its charts are compared with. */
type Compared = Pick<DisplayMesh, 'positions' | 'faces'> & Pick<DensityArrays, 'isByTile'>;

const surfaceOf = (
  arrays: ChartArrays,
  layout: PlacedVertices,
  { faces, isByTile, ...input }: Compared,
): DensityArrays => ({ ...arrays, positions: positionsOf(layout, input), faces, isByTile });

const tasks = {
  /** Loads what has not been needed yet. */
  rest: async (): Promise<void> => {
    await Promise.all(LATER.map((load) => load()));
  },

  mesh: (mesh: DisplayMesh): Drawing => handedOver(drawMesh(meshPicture(mesh))),

  layout: (layout: LayoutArrays, input: DisplayMesh, chart: MarkedChart | null): FlatDrawing =>
    handedOver(drawFlat(flatPicture(layout, input, chart), 0)),

  atlas: (atlas: AtlasArrays, size: AtlasSize, input: DisplayMesh): FlatDrawing =>
    handedOver(drawFlat(atlasPicture(atlas, size, input), size.chartCount)),

  moved: async (arrays: ChartArrays, motions: Motions): Promise<Float64Array> => {
    const { movedUv } = await arranging();
    return handedOver(movedUv(arrays, motions));
  },

  flipped: async (arrays: ChartArrays, charts: Uint32Array): Promise<Flipped> => {
    const { flipped } = await arranging();
    return handedOver(flipped(arrays, charts));
  },

  charts: async (
    arrays: ChartArrays,
    layout: PlacedVertices,
    input: Pick<DisplayMesh, 'positions'>,
    charts: Uint32Array,
  ): Promise<ChartMesh[]> => {
    const { chartMeshes } = await arranging();
    return handedOver(chartMeshes(arrays, positionsOf(layout, input), charts));
  },

  straightened: async (arrays: ChartArrays, charts: Uint32Array): Promise<Motions> =>
    (await arranging()).straightened(arrays, charts),

  stacked: async (arrays: ChartArrays, charts: Uint32Array, fixed: Uint32Array): Promise<Motions> =>
    (await arranging()).stacked(arrays, charts, fixed),

  sameShapes: async (arrays: ChartArrays, charts: Uint32Array): Promise<Set<number>> =>
    (await arranging()).sameShapes(arrays, charts),

  connectedParts: async (mesh: DisplayMesh): Promise<Uint32Array> =>
    handedOver((await arranging()).connectedParts(mesh)),

  stacks: async (arrays: ChartArrays): Promise<Stacks> => (await arranging()).stacksOf(arrays),

  fileStacks: async (arrays: ChartArrays, faults: Uint8Array, faces?: Uint32Array) =>
    handedOver((await arranging()).fileStacks(arrays, faults, faces)),

  fileIslands: async (
    arrays: ChartArrays,
    layout: PlacedVertices,
    input: Pick<DisplayMesh, 'positions' | 'faces'>,
    { faults }: { faults: Uint8Array },
    count: number,
  ) => {
    const { fileIslands } = await arranging();
    const { vertexMap } = layout;
    const shared = { ...arrays, vertexMap, faults, positions: positionsOf(layout, input) };
    return handedOver(fileIslands(shared, count, input.faces));
  },

  apart: async (arrays: ChartArrays, stacks: Stack[], rows: number) =>
    (await arranging()).apart(arrays, stacks, rows),

  restacked: async (before: ChartArrays, now: ChartArrays, stacks: Stack[]) =>
    (await arranging()).restacked(before, now, stacks),

  evened: async (
    arrays: ChartArrays,
    layout: PlacedVertices,
    input: Compared,
    charts: Uint32Array,
  ): Promise<Motions> => {
    const { evened } = await arranging();
    return evened(surfaceOf(arrays, layout, input), charts);
  },

  atDensity: async (
    arrays: ChartArrays,
    layout: PlacedVertices,
    input: Compared,
    charts: Uint32Array,
    density: number,
    asked: FaceDensities,
  ): Promise<Motions> => {
    const { atDensity } = await arranging();
    const surface = surfaceOf(arrays, layout, input);
    return atDensity(surface, charts, density, asked);
  },

  keptDensities: async (
    arrays: ChartArrays,
    layout: PlacedVertices,
    input: Compared,
    { uv }: Pick<ChartArrays, 'uv'>,
    asked: FaceDensities,
  ): Promise<FaceDensities> => {
    const { keptDensities } = await arranging();
    const before = surfaceOf(arrays, layout, input);
    return keptDensities(before, uv, asked);
  },

  surface: async (mesh: DisplayMesh, isDisk: boolean): Promise<SurfaceArrays> => {
    const { makeSurface } = await surfaces();
    return handedOver(makeSurface(mesh, isDisk));
  },

  png: async (drawing: AtlasDrawing): Promise<Blob> => (await writing()).atlasPng(drawing),

  heatMap: async (
    drawing: AtlasDrawing,
    layout: PlacedVertices,
    input: Pick<DisplayMesh, 'positions'>,
  ): Promise<Blob> => {
    const { heatMapPng } = await writing();
    return heatMapPng(drawing, positionsOf(layout, input));
  },

  gltf: async (chosen: ChosenGltf) => {
    const read = await (await gltfFile()).readGltf(chosen);
    return read && transfer(read, buffersOf(read.mesh));
  },

  longGltf: async (chosen: ChosenGltf) => {
    const read = await (await gltfFile()).readLong(chosen);
    return transfer(read, buffersOf(read.mesh));
  },

  glb: async (files: GltfFiles, layout: LayoutArrays, texcoord: number): Promise<Blob> =>
    (await gltfFile()).writeGltf(files, layout, texcoord),

  baked: async (...work: Parameters<typeof bake>): Promise<BakedGltf> =>
    (await baking()).bake(...work),

  bakedObj: async (...work: Parameters<typeof bakeObj>): Promise<BakedGltf> =>
    (await baking()).bakeObj(...work),

  newGlb: async (
    name: string,
    layout: LayoutArrays,
    input: Pick<DisplayMesh, 'positions'>,
  ): Promise<Blob> => {
    const { newGlb } = await newGlbFile();
    return newGlb(name, layout, positionsOf(layout, input));
  },

  shapeGlb: async (name: string, { positions, indices }: DisplayMesh): Promise<Blob> => {
    const { newGlb } = await newGlbFile();
    return newGlb(name, { indices }, positions);
  },

  appearance: async (source: LookSource, mesh: LookMesh): Promise<AppearanceRead> => {
    if (!(await hasLook(source.file, source.gltf))) return { appearance: null, remarks: [] };
    const { readAppearance } = await appearanceFile();
    const read = await readAppearance(source, mesh);
    const { corners, images = [] } = read.appearance ?? {};
    return transfer(read, [...buffersOf(corners), ...images]);
  },

  objParts: async (
    file: File,
    triangles: number,
    { faces }: Pick<DisplayMesh, 'faces'>,
  ): Promise<NamedParts> => {
    const [{ objParts: read }, text] = await Promise.all([objParts(), file.text()]);
    return read(text, triangles, faces);
  },

  joined: async (mesh: ArrayMesh): Promise<ArrayMesh> => {
    const { joined } = await writing();
    return handedOver(joined(mesh));
  },

  joinedGlb: async (files: GltfFiles[]): Promise<Blob> => (await joinedGltf()).joinedGlb(files),

  joinedObj: async (meshes: NamedMesh[]): Promise<Blob> => {
    const { joinedObj } = await writing();
    return new Blob(joinedObj(meshes), { type: exportedFile('obj').type });
  },

  unzipped: async (archive: File): Promise<File[]> => (await zip()).unzipped(archive),

  svg: async (drawing: AtlasDrawing, millimetres: number | 'auto'): Promise<Blob> => {
    const { atlasSvg } = await writing();
    return new Blob([atlasSvg(drawing, millimetres)], { type: 'image/svg+xml' });
  },
};

export type Tasks = typeof tasks;

/** Transferred, not copied. */
function handedOver<T extends object>(value: T): T {
  return transfer(value, buffersOf(value));
}

expose(tasks);
