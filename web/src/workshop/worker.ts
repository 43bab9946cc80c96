// The worker's side of workshop.ts: everything that loops over all triangles is done here, off the
// main thread.

import { expose, transfer } from 'comlink';
import { type ChartMesh, chartMesh } from '../arrange/chart-mesh';
import type { ChartArrays } from '../arrange/charts';
import { evened } from '../arrange/density';
import { type Motions, movedUv } from '../arrange/move-charts';
import { stacked } from '../arrange/stack';
import { straightened } from '../arrange/straighten';
import { buffersOf } from '../base/buffers';
import { loadInWorker } from '../base/load-part';
import { drawFlat } from '../drawing/draw';
import { drawMesh } from '../drawing/draw-mesh';
import {
  type AtlasArrays,
  type AtlasSize,
  atlasPicture,
  flatPicture,
  type MarkedChart,
  meshPicture,
  positionsOf,
} from '../drawing/picture';
import type { LookSource } from '../files/appearance';
import { hasLook } from '../files/has-look';
import { joinedObj, type NamedMesh } from '../files/joined-obj';
import { atlasPng, heatMapPng } from '../files/png-file';
import type { LookMesh } from '../files/stored-look';
import { type AtlasDrawing, atlasSvg } from '../files/svg-text';
import type { ArrayMesh, DisplayMesh } from '../mesh/mesh';
import { joined } from '../mesh/weld';
import type { AppearanceRead } from '../model/appearance';
import type { Drawing, FlatDrawing } from '../model/drawing';
import type { GltfFiles, LayoutArrays } from '../model/model';
import { makeSurface, type SurfaceArrays } from '../surface/make-surface';

// What reads and writes glTF and materials is not part of the first load.
const gltfFile = () => loadInWorker(import('../files/gltf-file'));

const newGlbFile = () => loadInWorker(import('../files/new-glb'));
const appearanceFile = () => loadInWorker(import('../files/appearance'));

const tasks = {
  /** Loads what has not been needed yet. */
  rest: async (): Promise<void> => {
    await Promise.all([gltfFile(), newGlbFile(), appearanceFile()]);
  },

  mesh: (mesh: DisplayMesh): Drawing => handedOver(drawMesh(meshPicture(mesh))),

  layout: (layout: LayoutArrays, input: DisplayMesh, chart: MarkedChart | null): FlatDrawing =>
    handedOver(drawFlat(flatPicture(layout, input, chart), 0)),

  atlas: (atlas: AtlasArrays, size: AtlasSize, input: DisplayMesh): FlatDrawing =>
    handedOver(drawFlat(atlasPicture(atlas, size, input), size.chartCount)),

  moved: (arrays: ChartArrays, motions: Motions): Float64Array =>
    handedOver(movedUv(arrays, motions)),

  chart: (
    arrays: ChartArrays,
    layout: Parameters<typeof positionsOf>[0],
    input: Parameters<typeof positionsOf>[1],
    chart: number,
  ): ChartMesh => handedOver(chartMesh(arrays, positionsOf(layout, input), chart)),

  straightened: (arrays: ChartArrays, charts: Uint32Array): Motions => straightened(arrays, charts),

  stacked: (arrays: ChartArrays, charts: Uint32Array, fixed: Uint32Array): Motions =>
    stacked(arrays, charts, fixed),

  evened: (
    arrays: ChartArrays,
    layout: Parameters<typeof positionsOf>[0],
    input: Parameters<typeof positionsOf>[1],
    charts: Uint32Array,
  ): Motions => evened({ ...arrays, positions: positionsOf(layout, input) }, charts),

  surface: (mesh: DisplayMesh, isDisk: boolean): SurfaceArrays =>
    handedOver(makeSurface(mesh, isDisk)),

  png: (drawing: AtlasDrawing): Promise<Blob> => atlasPng(drawing),

  heatMap: (
    drawing: AtlasDrawing,
    layout: Parameters<typeof positionsOf>[0],
    input: Parameters<typeof positionsOf>[1],
  ): Promise<Blob> => heatMapPng(drawing, positionsOf(layout, input)),

  gltf: async (file: File, others: File[]) => {
    const read = await (await gltfFile()).readGltf(file, others);
    return read && transfer(read, buffersOf(read.mesh));
  },

  compressed: async (file: File, others: File[]) => {
    const read = await (await gltfFile()).readCompressed(file, others);
    return transfer(read, buffersOf(read.mesh));
  },

  glb: async (files: GltfFiles, layout: LayoutArrays, texcoord: number): Promise<Blob> =>
    (await gltfFile()).writeGltf(files, layout, texcoord),

  newGlb: async (
    name: string,
    layout: LayoutArrays,
    input: Parameters<typeof positionsOf>[1],
  ): Promise<Blob> => {
    const { newGlb } = await newGlbFile();
    return newGlb(name, layout, positionsOf(layout, input));
  },

  appearance: async (source: LookSource, mesh: LookMesh): Promise<AppearanceRead> => {
    if (!(await hasLook(source.file, source.gltf))) return { appearance: null, remarks: [] };
    const { readAppearance } = await appearanceFile();
    const read = await readAppearance(source, mesh);
    const { corners, images = [] } = read.appearance ?? {};
    return transfer(read, [...buffersOf(corners), ...images]);
  },

  joined: (mesh: ArrayMesh): ArrayMesh => handedOver(joined(mesh)),

  joinedObj: (meshes: NamedMesh[]): Blob => new Blob(joinedObj(meshes), { type: 'model/obj' }),

  svg: (drawing: AtlasDrawing, millimetres: number | 'auto'): Blob =>
    new Blob([atlasSvg(drawing, millimetres)], { type: 'image/svg+xml' }),
};

export type Tasks = typeof tasks;

/** Transferred, not copied. */
function handedOver<T extends object>(value: T): T {
  return transfer(value, buffersOf(value));
}

expose(tasks);
