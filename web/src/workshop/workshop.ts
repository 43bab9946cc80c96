import { type Remote, wrap } from 'comlink';
import type { Drawing, FlatDrawing } from '../drawing/drawing';
import type { Outcome, Unwrapped } from '../lay-out';
import type { AtlasDrawing } from '../layout-file/svg-text';
import type { ArrayMesh, DisplayMesh } from '../mesh';
import type { LayoutArrays } from '../picture';
import type { Surface } from '../seams/seam-model';
import type { FileSource, Helpers } from '../session';
import type { GltfFile } from './gltf-file';
import type { Tasks } from './worker';

/** A worker for what takes long with large meshes, so that the page always answers. It is started with the page. */
export class Workshop implements Helpers {
  private readonly tasks: Remote<Tasks>;

  constructor() {
    this.tasks = wrap<Tasks>(
      new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'workshop' }),
    );
  }

  /** A mesh that is not flattened yet. */
  mesh({ positions, indices }: DisplayMesh): Promise<Drawing> {
    return this.tasks.mesh({ positions, indices });
  }

  outcome(outcome: Outcome): Promise<FlatDrawing> {
    const { result, mode, mesh } = outcome;
    if (mode === 'flatten') return this.layout(result, mesh, result.report.charts[0]);
    const { uv, indices, vertexMap, positions, chartOfTriangle, report } = result;
    return this.tasks.atlas(
      { uv, indices, vertexMap, positions, chartOfTriangle },
      { tiles: report.atlas.tiles, chartCount: report.charts.length },
      { positions: mesh.positions, indices: mesh.indices },
    );
  }

  layout(
    { uv, indices, vertexMap, positions }: LayoutArrays,
    mesh: DisplayMesh,
    chart: Parameters<Tasks['layout']>[2],
  ): Promise<FlatDrawing> {
    return this.tasks.layout(
      { uv, indices, vertexMap, positions },
      { positions: mesh.positions, indices: mesh.indices },
      chart && { bounds: chart.bounds, delaunay: chart.delaunay },
    );
  }

  /** What it takes to edit seams. */
  surface({ positions, indices, faces }: DisplayMesh, isDisk: boolean): Promise<Surface> {
    return this.tasks.surface({ positions, indices, faces }, isDisk);
  }

  png(drawing: AtlasDrawing): Promise<Blob> {
    return this.tasks.png(drawing);
  }

  heatMap(drawing: AtlasDrawing, { result, mesh }: Unwrapped): Promise<Blob> {
    const { positions, vertexMap } = result;
    return this.tasks.heatMap(drawing, { positions, vertexMap }, { positions: mesh.positions });
  }

  svg(drawing: AtlasDrawing, millimetres: number | 'auto'): Promise<Blob> {
    return this.tasks.svg(drawing, millimetres);
  }

  gltf({ file, others }: FileSource): Promise<GltfFile> {
    return this.tasks.gltf(file, others);
  }

  /** The document that the mesh came from as GLB, with the coordinates of the layout as TEXCOORD_`texcoord`. */
  async glb({ gltf, result }: Outcome, texcoord: number): Promise<Blob | undefined> {
    const { uv, indices, vertexMap, positions } = result;
    return gltf && this.tasks.glb(gltf.files, { uv, indices, vertexMap, positions }, texcoord);
  }

  /** With vertices at one place joined. */
  joined(mesh: ArrayMesh): Promise<ArrayMesh> {
    return this.tasks.joined(mesh);
  }
}
