import { type Remote, transfer, wrap } from 'comlink';
import type { ChartMesh } from '../arrange/chart-mesh';
import type { ChartArrays } from '../arrange/charts';
import type { Motions } from '../arrange/move-charts';
import { buffersOf, copied } from '../base/buffers';
import { NOT_LOADED, notLoaded, stopped } from '../base/lost';
import type { NamedMesh } from '../files/joined-obj';
import type { AtlasDrawing } from '../files/svg-text';
import type { ArrayMesh, DisplayMesh } from '../mesh/mesh';
import type { AppearanceRead } from '../model/appearance';
import type { Drawing, FlatDrawing } from '../model/drawing';
import type { FaceDensities } from '../model/face-densities';
import type {
  ChosenGltf,
  FileSource,
  GltfFile,
  Helpers,
  LayoutArrays,
  Opened,
  Outcome,
  Unwrapped,
} from '../model/model';
import type { Stack, Stacks } from '../model/stacks';
import type { SurfaceArrays } from '../surface/make-surface';
import { LOST } from '../words/base';
import { KeptColors } from './kept-colors';
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

interface Running {
  tasks: Remote<Tasks>;
  /** Rejects if the worker cannot be loaded or stops. */
  lost: Promise<never>;
  end: () => void;
}

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
    const { uv, indices, vertexMap, positions, chartOfTriangle, report } = result;
    const chartCount = report.charts.length;
    const colors = this.colors.of(chartOfTriangle, chartCount);
    const asked = outcome.settings.faceDensities;
    const size = { tiles: report.atlas.tiles, chartCount, colors, asked };
    return this.send(
      [{ uv, indices, vertexMap, positions, chartOfTriangle }, trianglesOf(mesh)],
      (tasks, atlas, input) => tasks.atlas(atlas, size, input),
    ).then((drawing) => {
      this.colors.keep(chartOfTriangle, drawing.chartColors);
      return drawing;
    });
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

  /** How to move charts so that they are arranged. */
  async motions({ result, mesh, settings }: Unwrapped, arranged: Arranged): Promise<Motions> {
    if ('motions' in arranged) return arranged;
    const { charts } = arranged;
    const { positions, vertexMap } = result;
    const { faces } = mesh;
    const parts = [
      { positions, vertexMap },
      { positions: mesh.positions, faces },
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

  stacks(atlas: ChartArrays): Promise<Stacks> {
    return this.send([chartArraysOf(atlas)], (tasks, own) => tasks.stacks(own));
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
        { positions: mesh.positions, faces },
        { uv },
      ],
      (tasks, own, layout, input, now) =>
        tasks.keptDensities(own, layout, input, now, settings.faceDensities),
    );
  }

  /** A chart as a mesh of its own. */
  chart({ result, mesh }: Unwrapped, chart: number): Promise<ChartMesh> {
    const { positions, vertexMap } = result;
    return this.send(
      [chartArraysOf(result), { positions, vertexMap }, { positions: mesh.positions }],
      (tasks, own, layout, input) => tasks.chart(own, layout, input, chart),
    );
  }

  /** What is needed to edit seams. */
  surface({ positions, indices, faces }: DisplayMesh, isDisk: boolean): Promise<SurfaceArrays> {
    return this.send([{ positions, indices, faces }], (tasks, mesh) => tasks.surface(mesh, isDisk));
  }

  png(drawing: AtlasDrawing): Promise<Blob> {
    return this.send([drawing], (tasks, own) => tasks.png(own));
  }

  heatMap(drawing: AtlasDrawing, { result, mesh }: Unwrapped): Promise<Blob> {
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
    return read ?? compressed(chosen, signal);
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

  /** The mesh with vertices at the same point joined. */
  joined(mesh: ArrayMesh): Promise<ArrayMesh> {
    return this.send([mesh], (tasks, own) => tasks.joined(own));
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

function startWorker(name: string, onLost: () => void): Running {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name });
  const lost = new Promise<never>((_, reject) => {
    worker.onerror = (event) => {
      event.preventDefault();
      worker.terminate();
      onLost();
      // A script that cannot be loaded has no message.
      reject(event.message ? stopped(event.message) : notLoaded(LOST.noWorker));
    };
  });
  lost.catch(() => undefined); // callers that wait for the worker get this error
  return { tasks: wrap<Tasks>(worker), lost, end: () => worker.terminate() };
}

/**
 * In a separate worker: the decoder's memory is freed with it, and data that would keep it busy
 * forever can be cancelled.
 */
async function compressed(chosen: ChosenGltf, signal: AbortSignal): Promise<GltfFile> {
  signal.throwIfAborted();
  const { tasks, lost, end } = startWorker('decoder', () => undefined);
  const aborted = new Promise<never>((_, reject) => {
    signal.addEventListener('abort', () => reject(signal.reason));
  });
  try {
    return await Promise.race([tasks.compressed(chosen), lost, aborted]);
  } catch (error) {
    return explained(error as Error);
  } finally {
    end();
  }
}

/** The class of an error does not survive the message. */
function explained(error: Error): never {
  throw error.name === NOT_LOADED ? notLoaded(error.message) : error;
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
