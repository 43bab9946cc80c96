// The atlas of watlas, with the layouts of abflat.

import { AbflatError } from '../base/errors.js';
import type { AbflatSync, UnwrapOptions, UnwrapResult } from '../types/index.js';
import { type Part, readMesh, readUvMesh } from './decl.js';
import { joined } from './join.js';
import { checkIndex, fill, Mesh } from './mesh.js';
import { type Read, readChartOptions, readPackOptions } from './options.js';
import { Placer, type Run } from './place.js';
import { type PartLayout, type Placed, placedOf, splitLayout } from './split.js';
import { spread } from './spread.js';
import type { ChartOptions, MeshDecl, PackOptions, UvMeshDecl } from './types.js';

/** What lays out: abflat in this thread. */
export type Engine = Pick<AbflatSync, 'unwrap' | 'pack'>;

/** Options of abflat that xatlas does not have. */
export type MoreOptions = Omit<
  UnwrapOptions,
  'resolution' | 'padding' | 'margin' | 'texelDensity' | 'udim' | 'transfer' | 'obj' | 'ply'
>;

/** A layout of all meshes. */
interface Laid {
  parts: readonly Part[];
  placed: Placed;
  side: number;
  tiles: number;
  texelsPerUnit: number;
}

const NOTHING: Placed = {
  uv: new Float64Array(),
  vertexMap: new Uint32Array(),
  indices: new Uint32Array(),
  chartOfTriangle: new Int32Array(),
  tileOfTriangle: new Int32Array(),
};

/** Meshes that share an atlas. */
export class AtlasOf {
  readonly #engine: Engine;
  readonly #more: MoreOptions;
  #parts: Part[] = [];
  #hasUvMeshes: boolean | undefined;
  #chartOptions: Read<ChartOptions> | undefined;
  /** The layout whose charts are packed again. */
  #charts: UnwrapResult | undefined;
  #laid: Laid | undefined;
  #layouts: PartLayout[] = [];
  #notes: string[] = [];

  constructor(engine: Engine, more: MoreOptions) {
    this.#engine = engine;
    this.#more = more;
  }

  /** Copies the arrays. */
  addMesh(decl: MeshDecl): void {
    this.#add(readMesh(decl), false);
  }

  /** A mesh whose charts are packed as they are. */
  addUvMesh(decl: UvMeshDecl): void {
    this.#add(readUvMesh(decl), true);
  }

  #add(part: Part, isUvMesh: boolean): void {
    if (this.#hasUvMeshes !== undefined && this.#hasUvMeshes !== isUvMesh)
      throw new AbflatError('InvalidMesh', 'An atlas has meshes or uv meshes, not both.');
    this.#hasUvMeshes = isUvMesh;
    this.#parts.push(part);
    this.#charts = undefined;
  }

  /** `computeCharts` and `packCharts` in one. */
  generate(chartOptions?: ChartOptions, packOptions?: PackOptions): void {
    this.#chartOptions = readChartOptions(chartOptions);
    this.#charts = undefined;
    this.packCharts(packOptions);
  }

  /** Finds seams and flattens charts. `packCharts` may follow several times. */
  computeCharts(options?: ChartOptions): void {
    this.generate(options);
  }

  packCharts(options?: PackOptions): void {
    const read = readPackOptions(options);
    this.#chartOptions ??= readChartOptions();
    this.#notes = [...this.#chartOptions.notes, ...read.notes];
    this.#laid = this.#lay(read.values);
    const { parts, placed, side } = this.#laid;
    this.#layouts = splitLayout(parts, placed, side);
    for (const note of this.#notes) console.warn(`abflat: ${note}`);
  }

  #lay(options: Required<PackOptions>): Laid {
    const parts = this.#parts;
    if (parts.some(({ isDrawn }) => isDrawn.includes(1))) {
      try {
        return this.#keepsCharts() ? this.#packed(options) : this.#unwrapped(options);
      } catch (error) {
        if (!(error instanceof AbflatError) || error.code !== 'EmptyMesh') throw error;
      }
    }
    // There is no face, or each is degenerate once vertices in the same place are one.
    const none = parts.map((part) => ({ ...part, isDrawn: part.isDrawn.map(() => 0) }));
    return { parts: none, placed: NOTHING, side: 1, tiles: 0, texelsPerUnit: 0 };
  }

  /** Whether the layouts of the meshes are only packed. */
  #keepsCharts(): boolean {
    if (this.#hasUvMeshes) return true;
    if (!this.#chartOptions?.values.useInputMeshUvs) return false;
    const isPossible = this.#parts.every(({ uvs }) => uvs);
    if (!isPossible)
      this.#notes.push('useInputMeshUvs is ignored: not all meshes have vertexUvData.');
    return isPossible;
  }

  #unwrapped(options: Required<PackOptions>): Laid {
    const parts = this.#parts;
    const { texcoords: _, ...mesh } = joined(parts);
    const known = this.#charts;
    const seams = mesh.materials ? { seams: 'auto,material' } : {};
    const again = known ? { seams: 'none', seamEdges: known.seams, known } : {};
    const run: Run<UnwrapResult> = (where) => {
      const layout = this.#engine.unwrap(mesh, { ...seams, ...this.#more, ...again, ...where });
      return { layout, numbers: layout.report.atlas };
    };
    const placer = new Placer(run, options);
    const { layout, numbers } = placer.place();
    this.#charts = layout;
    this.#notes.push(...placer.notes);
    this.#tellFaults(layout.report.valid, layout.uv);
    return {
      parts,
      placed: placedOf(layout, layout.chartOfTriangle),
      side: numbers.resolution,
      tiles: numbers.tiles,
      texelsPerUnit: numbers.texelDensity,
    };
  }

  #packed(options: Required<PackOptions>): Laid {
    const parts = this.#parts;
    const { positions, indices } = joined(parts);
    const uvs = new Float64Array((2 * positions.length) / 3);
    let at = 0;
    for (const part of parts) {
      uvs.set(part.uvs ?? [], at);
      at += (2 * part.positions.length) / 3;
    }
    const mesh = { positions, indices, texcoords: spread(uvs, indices) };
    const placer = new Placer((where) => {
      const layout = this.#engine.pack(mesh, where);
      return { layout, numbers: layout.report };
    }, options);
    const { layout, numbers } = placer.place();
    this.#notes.push(...placer.notes);
    this.#tellFaults(layout.report.valid, layout.uv);
    return {
      parts,
      placed: placedOf(layout, layout.islandOfTriangle),
      side: numbers.resolution,
      tiles: numbers.tiles,
      texelsPerUnit: numbers.texelDensity,
    };
  }

  #tellFaults(isValid: boolean, uv: Float64Array): void {
    if (!isValid)
      this.#notes.push('The layout is not valid: some triangles are flipped or overlap.');
    else if (uv.some((x) => Math.fround(x) !== x))
      this.#notes.push(
        'Rounding to single precision may flip triangles: the layout is valid in double precision only.',
      );
  }

  get meshCount(): number {
    return this.#layouts.length;
  }

  getMesh(index: number): Mesh {
    const i = checkIndex('mesh', index, this.#layouts.length);
    return new Mesh(this.#layouts[i] as PartLayout);
  }

  get width(): number {
    return this.#laid?.side ?? 0;
  }

  get height(): number {
    return this.width;
  }

  get atlasCount(): number {
    return this.#laid?.tiles ?? 0;
  }

  get chartCount(): number {
    return this.#layouts.reduce((sum, layout) => sum + new Mesh(layout).chartCount, 0);
  }

  get texelsPerUnit(): number {
    return this.#laid?.texelsPerUnit ?? 0;
  }

  /** What differs from what was asked for, one sentence each. They are also logged as warnings. */
  get notes(): readonly string[] {
    return this.#notes;
  }

  /** The share of each atlas that triangles cover. Returns false if the array is too short. */
  getUtilization(array: Float32Array): boolean {
    return fill(array, this.#laid ? utilizationOf(this.#laid) : []);
  }

  /** Lets go of the arrays. */
  delete(): void {
    this.#parts = [];
    this.#hasUvMeshes = undefined;
    this.#charts = undefined;
    this.#laid = undefined;
    this.#layouts = [];
  }
}

function utilizationOf({ tiles, placed }: Laid): number[] {
  const shares = new Array<number>(tiles).fill(0);
  const { uv, indices, tileOfTriangle } = placed;
  for (const [triangle, tile] of tileOfTriangle.entries()) {
    const [a, b, c] = [0, 1, 2].map((k) => indices[3 * triangle + k] as number) as [
      number,
      number,
      number,
    ];
    const side = (from: number, to: number, axis: number) =>
      (uv[2 * to + axis] as number) - (uv[2 * from + axis] as number);
    const cross = side(a, b, 0) * side(a, c, 1) - side(a, b, 1) * side(a, c, 0);
    if (tile in shares) shares[tile] = (shares[tile] as number) + Math.abs(cross) / 2;
  }
  return shares;
}
