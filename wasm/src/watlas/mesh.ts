// Results, as watlas gives them.

import { AbflatError } from '../base/errors.js';
import { shown, tagOf } from '../messages/validate.js';
import { ChartType } from './chart-type.js';
import { NONE, type PartLayout } from './split.js';
import type { Vertex } from './types.js';

/** Checks an index of a caller. */
export function checkIndex(what: string, index: unknown, count: number): number {
  if (Number.isInteger(index) && (index as number) >= 0 && (index as number) < count)
    return index as number;
  throw new AbflatError(
    'InvalidOption',
    `There is no ${what} ${shown(index)}: there are ${count}, from 0 on.`,
  );
}

/** Fills an array of a caller. Returns false if it is too short. */
export function fill<T extends Uint32Array | Float32Array>(to: T, values: ArrayLike<number>) {
  if (!/^(Uint32|Float32)Array$/.test(tagOf(to)) || to.length < values.length) return false;
  to.set(values);
  return true;
}

export class Chart {
  readonly atlasIndex: number;
  readonly type: ChartType = ChartType.LSCM;
  readonly material: number;
  readonly #faces: Uint32Array;

  constructor(faces: Uint32Array, atlasIndex: number, material: number) {
    this.#faces = faces;
    this.atlasIndex = atlasIndex;
    this.material = material;
  }

  get faceCount(): number {
    return this.#faces.length;
  }

  /** Returns false if the array is too short. */
  getFaceArray(array: Uint32Array): boolean {
    return fill(array, this.#faces);
  }
}

export class Mesh {
  readonly #layout: PartLayout;
  #facesOfCharts: Uint32Array[] | undefined;

  constructor(layout: PartLayout) {
    this.#layout = layout;
  }

  get vertexCount(): number {
    return this.#layout.xrefs.length;
  }

  get indexCount(): number {
    return this.#layout.indices.length;
  }

  get chartCount(): number {
    return this.#charts().length;
  }

  /** Three vertices per face, in the order that the faces were given. Returns false if the array is too short. */
  getIndexArray(array: Uint32Array): boolean {
    return fill(array, this.#layout.indices);
  }

  getVertex(index: number): Vertex {
    const { uvs, xrefs, tileOfVertex, chartOfVertex } = this.#layout;
    const i = checkIndex('vertex', index, xrefs.length);
    return {
      atlasIndex: tileOfVertex[i] as number,
      chartIndex: chartOfVertex[i] as number,
      uv: [uvs[2 * i] as number, uvs[2 * i + 1] as number],
      xref: xrefs[i] as number,
    };
  }

  getChart(index: number): Chart {
    const charts = this.#charts();
    const faces = charts[checkIndex('chart', index, charts.length)] as Uint32Array;
    const { tileOfFace, materialOfFace } = this.#layout;
    const first = faces[0] as number;
    return new Chart(faces, tileOfFace[first] as number, materialOfFace[first] as number);
  }

  #charts(): Uint32Array[] {
    this.#facesOfCharts ??= facesOfCharts(this.#layout);
    return this.#facesOfCharts;
  }
}

function facesOfCharts({ chartOfFace }: PartLayout): Uint32Array[] {
  const faces = new Map<number, number[]>();
  for (const [face, chart] of chartOfFace.entries()) {
    if (chart === NONE) continue;
    const list = faces.get(chart) ?? [];
    list.push(face);
    faces.set(chart, list);
  }
  return [...faces.keys()]
    .sort((a, b) => a - b)
    .map((chart) => Uint32Array.from(faces.get(chart) ?? []));
}
