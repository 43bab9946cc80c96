import { type Remote, transfer } from 'comlink';
import type { ChartMesh } from '../arrange/chart-mesh';
import type { ChartArrays } from '../arrange/charts';
import type { Flipped } from '../arrange/flip';
import type { Motions } from '../arrange/move-charts';
import { buffersOf, copied } from '../base/buffers';
import { meshFileOf } from '../base/mesh-files';
import type { AtlasArrays, AtlasSize } from '../drawing/picture';
import type { NamedMesh } from '../files/joined-obj';
import type { AtlasDrawing } from '../files/svg-text';
import type { ArrayMesh, DisplayMesh } from '../mesh/mesh';
import type { AppearanceRead } from '../model/appearance';
import type { Arrangeable, FileLayout } from '../model/arrangeable';
import type { Drawing, FlatDrawing } from '../model/drawing';
import type { FaceDensities } from '../model/face-densities';
import type {
  FileSource,
  GltfFile,
  Helpers,
  LayoutArrays,
  Opened,
  Outcome,
  Packed,
  Unwrapped,
} from '../model/model';
import { type NamedParts, NO_PARTS } from '../model/named-parts';
import type { FileStacks, Stack, Stacks } from '../model/stacks';
import type { SurfaceArrays } from '../surface/make-surface';
import { KeptColors } from './kept-colors';
import { explained, inOwnWorker, type Running, startWorker } from './start-worker';
import type { Tasks } from './worker';

/** What can be done to some charts at once: an upright box, one on the other, as many texels as the rest. */
export type Arrangement = 'straightened' | 'stacked' | 'evened';

/**
 * How charts are to be moved: by motions, so that they are arranged, or to a texel density relative
 * to the others. `fixed`: charts that stay, but count.
 */
export type Arranged =
  | Motions
  | { how: Arrangement; charts: Uint32Array; fixed: Uint32Array }
  | { density: number; charts: Uint32Array };

/**
 * A worker for everything slow with large meshes, so that the page stays responsive. It is started
 * with the page, and again if it is lost.
 */
export class Workshop implements Helpers {
  private running: Running | null = null;
  private readonly colors = new KeptColors();
  /** Resolves when everything that was sent has been copied. */
  private sent: Promise<void> = Promise.resolve();

  constructor() {
    this.running = this.start();
  }

  private start(): Running {
    return startWorker('workshop', () => {
      this.running = null;
    });
  }

  /** Loads what a first layout does not need. */
  loadRest(): Promise<void> {
    return this.send([], (tasks) => tasks.rest());
  }

  /** Draws a mesh that is not flattened yet. */
  mesh({ positions, indices }: DisplayMesh): Promise<Drawing> {
    return this.send([{ positions, indices }], (tasks, mesh) => tasks.mesh(mesh));
  }

  outcome(outcome: Outcome): Promise<FlatDrawing> {
    const { result, mode, mesh } = outcome;
    if (mode === 'flatten') return this.layout(result, mesh, result.report.charts[0]);
    const { uv, indices, vertexMap, positions } = result;
    const arrays = { uv, indices, vertexMap, positions };
    if (mode === 'pack') {
      const { islandOfTriangle: chartOfTriangle, faults, report } = result;
      const marked = outcome.settings.keepPlaces
        ? { faults: outcome.fileStacks?.faults ?? faults }
        : {};
      const { tiles, resolution, islands: chartCount } = report;
      const size = { tiles, resolution, chartCount, isOfFile: true };
      return this.atlas({ ...arrays, chartOfTriangle, ...marked }, size, mesh);
    }
    const { chartOfTriangle, report } = result;
    const asked = outcome.settings.faceDensities;
    const { tiles, resolution } = report.atlas;
    const size = { tiles, resolution, chartCount: report.charts.length, asked };
    return this.atlas({ ...arrays, chartOfTriangle }, size, mesh);
  }

  private async atlas(
    atlas: AtlasArrays,
    size: Omit<AtlasSize, 'colors'>,
    mesh: DisplayMesh,
  ): Promise<FlatDrawing> {
    const { chartOfTriangle } = atlas;
    const colors = this.colors.of(chartOfTriangle, size.chartCount);
    const drawing = await this.send([atlas, trianglesOf(mesh)], (tasks, own, input) =>
      tasks.atlas(own, { ...size, colors }, input),
    );
    this.colors.keep(chartOfTriangle, drawing.chartColors);
    return drawing;
  }

  layout(
    { uv, indices, vertexMap, positions }: LayoutArrays,
    mesh: DisplayMesh,
    chart: Parameters<Tasks['layout']>[2],
  ): Promise<FlatDrawing> {
    const marked = chart && { bounds: chart.bounds, delaunay: chart.delaunay };
    return this.send(
      [{ uv, indices, vertexMap, positions }, trianglesOf(mesh)],
      (tasks, layout, input) => tasks.layout(layout, input, marked),
    );
  }

  /** The coordinates of an atlas whose charts are moved. */
  moved(atlas: ChartArrays, motions: Motions): Promise<Float64Array> {
    return this.send([chartArraysOf(atlas)], (tasks, own) => tasks.moved(own, motions));
  }

  /** The coordinates of an atlas with charts mirrored in their places. */
  flipped(atlas: ChartArrays, charts: Uint32Array): Promise<Flipped> {
    return this.send([chartArraysOf(atlas)], (tasks, own) => tasks.flipped(own, charts));
  }

  /** How to move charts so that they are arranged. */
  async motions({ result, mesh, settings }: Arrangeable, arranged: Arranged): Promise<Motions> {
    if ('motions' in arranged) return arranged;
    const { charts } = arranged;
    const { positions, vertexMap } = result;
    const { faces } = mesh;
    const parts = [
      { positions, vertexMap },
      { positions: mesh.positions, faces, isByTile: settings.tiles !== undefined },
    ] as const;
    return this.send([chartArraysOf(result), ...parts], (tasks, own, layout, input) => {
      if ('density' in arranged) {
        const { density } = arranged;
        return tasks.atDensity(own, layout, input, charts, density, settings.faceDensities);
      }
      const { how, fixed } = arranged;
      if (how === 'straightened') return tasks.straightened(own, charts);
      if (how === 'stacked') return tasks.stacked(own, charts, fixed);
      return tasks.evened(own, layout, input, charts);
    });
  }

  /** The charts with the outline of one of some charts. */
  sameShapes(atlas: ChartArrays, charts: Uint32Array): Promise<Set<number>> {
    return this.send([chartArraysOf(atlas)], (tasks, own) => tasks.sameShapes(own, charts));
  }

  /** The number of the connected part that each triangle belongs to. */
  connectedParts({ positions, indices }: DisplayMesh): Promise<Uint32Array> {
    return this.send([{ positions, indices }], (tasks, mesh) => tasks.connectedParts(mesh));
  }

  stacks(atlas: ChartArrays): Promise<Stacks> {
    return this.send([chartArraysOf(atlas)], (tasks, own) => tasks.stacks(own));
  }

  fileStacks({ result, mesh }: Packed): Promise<FileStacks> {
    const { uv, indices, islandOfTriangle: chartOfTriangle, faults } = result;
    return this.send(
      [{ uv, indices, chartOfTriangle }, { faults }, { faces: mesh.faces }],
      (tasks, own, { faults }, { faces }) => tasks.fileStacks(own, faults, faces),
    );
  }

  apart(atlas: ChartArrays, stacks: Stack[], rows: number): Promise<Float64Array | null> {
    return this.send([chartArraysOf(atlas)], (tasks, own) => tasks.apart(own, stacks, rows));
  }

  restacked(before: ChartArrays, now: ChartArrays, stacks: Stack[]): Promise<Float64Array | null> {
    return this.send([chartArraysOf(before), chartArraysOf(now)], (tasks, old, own) =>
      tasks.restacked(old, own, stacks),
    );
  }

  /** What faces of an atlas ask for now that its charts are elsewhere; see arrange/density.ts. */
  keptDensities({ result, mesh, settings }: Unwrapped, uv: Float64Array): Promise<FaceDensities> {
    const { positions, vertexMap } = result;
    const { faces } = mesh;
    return this.send(
      [
        chartArraysOf(result),
        { positions, vertexMap },
        { positions: mesh.positions, faces, isByTile: settings.tiles !== undefined },
        { uv },
      ],
      (tasks, own, layout, input, now) =>
        tasks.keptDensities(own, layout, input, now, settings.faceDensities),
    );
  }

  /** Charts as meshes of their own. */
  charts({ result, mesh }: Arrangeable, charts: Uint32Array): Promise<ChartMesh[]> {
    const { positions, vertexMap } = result;
    return this.send(
      [chartArraysOf(result), { positions, vertexMap }, { positions: mesh.positions }],
      (tasks, own, layout, input) => tasks.charts(own, layout, input, charts),
    );
  }

  /** The islands of a file as charts. */
  async fileLayout(packed: Packed): Promise<FileLayout> {
    const { mode, source, mesh, gltf, result } = packed;
    const { uv, indices, islandOfTriangle: chartOfTriangle, positions, vertexMap, faults } = result;
    const { positions: places, faces } = mesh;
    const { islands, resolution } = result.report;
    const { arrays, facts } = await this.send(
      [
        { uv, indices, chartOfTriangle },
        { positions, vertexMap },
        { positions: places, faces },
        { faults },
      ],
      (tasks, own, layout, input, marks) => tasks.fileIslands(own, layout, input, marks, islands),
    );
    const report = { charts: facts, atlas: { resolution } };
    return { mode, source, mesh, gltf, packed, settings: {}, result: { ...arrays, report } };
  }

  /** What is needed to edit seams. */
  surface({ positions, indices, faces }: DisplayMesh, isDisk: boolean): Promise<SurfaceArrays> {
    return this.send([{ positions, indices, faces }], (tasks, mesh) => tasks.surface(mesh, isDisk));
  }

  png(drawing: AtlasDrawing): Promise<Blob> {
    return this.send([drawing], (tasks, own) => tasks.png(own));
  }

  heatMap(drawing: AtlasDrawing, { result, mesh }: Outcome): Promise<Blob> {
    const { positions, vertexMap } = result;
    return this.send(
      [drawing, { positions, vertexMap }, { positions: mesh.positions }],
      (tasks, own, layout, input) => tasks.heatMap(own, layout, input),
    );
  }

  svg(drawing: AtlasDrawing, millimetres: number | 'auto'): Promise<Blob> {
    return this.send([drawing], (tasks, own) => tasks.svg(own, millimetres));
  }

  async gltf({ file, others, texcoord = 0 }: FileSource, signal: AbortSignal): Promise<GltfFile> {
    const chosen = { file, others, texcoord };
    const read = await this.send([], (tasks) => tasks.gltf(chosen));
    return read ?? inOwnWorker('decoder', (tasks) => tasks.longGltf(chosen), signal);
  }

  /**
   * The document that the mesh came from as GLB, with the layout's coordinates as
   * TEXCOORD_`texcoord`; a new document called `name` if it came from none.
   */
  glb({ gltf, result, mesh }: Outcome, texcoord: number, name: string): Promise<Blob> {
    const { uv, indices, vertexMap, positions } = result;
    const layout = { uv, indices, vertexMap, positions };
    if (gltf) return this.send([layout], (tasks, own) => tasks.glb(gltf.files, own, texcoord));
    return this.send([layout, { positions: mesh.positions }], (tasks, own, input) =>
      tasks.newGlb(name, own, input),
    );
  }

  /** A mesh without a layout as a document of its own. */
  shapeGlb(name: string, { positions, indices }: DisplayMesh): Promise<Blob> {
    return this.send([{ positions, indices }], (tasks, own) => tasks.shapeGlb(name, own));
  }

  /** How a file looks, besides its shape; images take up to `memory` bytes. */
  async appearance(
    { file, others }: FileSource,
    { mesh, gltf }: Pick<Opened, 'mesh' | 'gltf'>,
    memory: number,
  ): Promise<AppearanceRead> {
    const source = { file, others, gltf: gltf?.files, memory };
    // A glTF is read again as a whole.
    const own = gltf
      ? { indices: new Uint32Array() }
      : { indices: mesh.indices, faces: mesh.faces };
    return this.send([own], (tasks, mesh) => tasks.appearance(source, mesh));
  }

  /** Objects and materials of a glTF or an OBJ; other meshes have none. */
  async namedParts({
    source,
    gltf,
    mesh,
  }: Pick<Opened, 'source' | 'gltf' | 'mesh'>): Promise<NamedParts> {
    if (gltf) return gltf.parts;
    if (source.kind !== 'file' || meshFileOf(source.name)?.format !== 'obj') return NO_PARTS;
    const { file } = source;
    const { indices, faces } = mesh;
    return this.send([{ faces }], (tasks, own) => tasks.objParts(file, indices.length / 3, own));
  }

  /** The mesh with vertices at the same point joined. */
  joined(mesh: ArrayMesh): Promise<ArrayMesh> {
    return this.send([mesh], (tasks, own) => tasks.joined(own));
  }

  /** The files in an archive. */
  unzipped(archive: File): Promise<File[]> {
    return this.send([], (tasks) => tasks.unzipped(archive));
  }

  /** The meshes as one OBJ. */
  joinedObj(meshes: NamedMesh[]): Promise<Blob> {
    return this.send(meshes, (tasks, ...own) => tasks.joinedObj(own));
  }

  /**
   * Sends the worker copies of all large values; it works on requests in the order they were made.
   */
  private send<A extends object[], R>(
    values: [...A],
    post: (tasks: Remote<Tasks>, ...own: A) => Promise<R>,
  ): Promise<R> {
    const copies = this.sent.then(async () => {
      const own: object[] = [];
      for (const value of values) own.push(await copied(value));
      return own;
    });
    this.sent = copies.then(
      () => undefined,
      () => undefined,
    );
    return copies.then((own) => {
      this.running ??= this.start();
      const { tasks, lost } = this.running;
      const given = own.map((each) => transfer(each, buffersOf(each))) as A;
      return Promise.race([post(tasks, ...given).catch(explained), lost]);
    });
  }
}

const chartArraysOf = ({ uv, indices, chartOfTriangle }: ChartArrays): ChartArrays => ({
  uv,
  indices,
  chartOfTriangle,
});

const trianglesOf = ({ positions, indices, faces }: DisplayMesh): DisplayMesh => ({
  positions,
  indices,
  faces,
});
