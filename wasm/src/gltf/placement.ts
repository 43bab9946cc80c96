// Where the nodes of a document put its meshes.

import type { Document, Mesh, mat4, Node } from '@gltf-transform/core';

export interface Placement {
  /** Column-major; undefined if vertices stay where they are. */
  matrix?: mat4;
  /** Corners run clockwise when seen from outside. */
  isMirrored: boolean;
}

const AS_IT_IS: Placement = { isMirrored: false };

/** How the nodes of a document use one mesh. */
interface Usage {
  placement: Placement;
  nodes: number;
  /** How much larger areas become, squared; 0 if all nodes flatten the mesh. */
  areaScale: number;
  /** The nodes make it differently large. */
  hasScales: boolean;
}

/**
 * Where the nodes of a document put its meshes, or those of its scene if it uses them. All nodes of a mesh share one layout, so only the
 * node that makes it largest counts, the first of several. A skinned mesh is where its vertices
 * are, and so is one that all nodes flatten.
 */
export class Placements {
  readonly #usages = new Map<Mesh, Usage>();

  constructor(document: Document) {
    const root = document.getRoot();
    const inScene: Node[] = [];
    (root.getDefaultScene() ?? root.listScenes()[0])?.traverse((node) => inScene.push(node));
    this.#add(inScene);
    const isOutside = (mesh: Mesh | null) => mesh !== null && !this.#usages.has(mesh);
    this.#add(root.listNodes().filter((node) => isOutside(node.getMesh())));
  }

  #add(nodes: Node[]): void {
    for (const node of nodes) {
      const mesh = node.getMesh();
      if (mesh) this.#usages.set(mesh, usedBy(node, this.#usages.get(mesh)));
    }
  }

  of(mesh: Mesh): Placement {
    return this.#usages.get(mesh)?.placement ?? AS_IT_IS;
  }

  /** Which meshes are in several places, in one note. */
  notes(meshes: Iterable<Mesh>): string[] {
    const shared = [...new Set(meshes)]
      .map((mesh) => this.#usages.get(mesh))
      .filter((usage): usage is Usage => usage !== undefined && usage.nodes > 1);
    if (shared.length === 0) return [];
    const nodes = shared.reduce((sum, usage) => sum + usage.nodes, 0);
    const scales = shared.some(({ hasScales }) => hasScales)
      ? '. Their scales differ, so each layout is sized for the largest node'
      : '';
    return [
      `${nodes} nodes share ${shared.length} ${shared.length === 1 ? 'mesh and its' : 'meshes and their'} texels${scales}`,
    ];
  }
}

function usedBy(node: Node, before: Usage | undefined): Usage {
  const matrix = node.getWorldMatrix();
  const volume = determinant(matrix);
  const isFlat = !node.getSkin() && (volume === 0 || !Number.isFinite(volume));
  const placement = node.getSkin() || isFlat ? AS_IT_IS : { matrix, isMirrored: volume < 0 };
  const areaScale = isFlat ? 0 : areaScaleOf(placement.matrix);
  const now = { placement, nodes: 1, areaScale, hasScales: false };
  if (!before) return now;
  const hasScales =
    before.hasScales ||
    (before.areaScale > 0 && areaScale > 0 && !isScaledAlike(before.placement, placement));
  const both = { nodes: before.nodes + 1, hasScales };
  // Nodes that differ by rounding only count as equally large.
  const isLarger = areaScale > before.areaScale * (1 + 1e-6);
  return isLarger ? { ...now, ...both } : { ...before, ...both };
}

/** The mean over all directions, up to a constant factor. */
function areaScaleOf(m: mat4 = IDENTITY): number {
  const column = (i: number) => [m[4 * i], m[4 * i + 1], m[4 * i + 2]] as Point;
  const [x, y, z] = [column(0), column(1), column(2)];
  return [cross(x, y), cross(y, z), cross(z, x)].reduce((sum, c) => sum + dot(c, c), 0);
}

function isScaledAlike(a: Placement, b: Placement): boolean {
  const [before, now] = [scalesOf(a.matrix), scalesOf(b.matrix)];
  const largest = Math.max(...before, ...now);
  // Well above the rounding of exporters.
  return before.every((x, i) => Math.abs(x - (now[i] as number)) <= 1e-3 * largest);
}

/** Scalar products of the axes: what is left of a placement without position and rotation. */
function scalesOf(m: mat4 = IDENTITY): number[] {
  const axes = [0, 4, 8].map((i) => [m[i], m[i + 1], m[i + 2]] as Point);
  return axes.flatMap((a) => axes.map((b) => dot(a, b)));
}

type Point = [number, number, number];

const IDENTITY: mat4 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

const dot = (a: Point, b: Point) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

function determinant(m: mat4): number {
  return (
    m[0] * (m[5] * m[10] - m[6] * m[9]) -
    m[4] * (m[1] * m[10] - m[2] * m[9]) +
    m[8] * (m[1] * m[6] - m[2] * m[5])
  );
}

/** Writes the point to where it is placed. */
export function put(
  [x = 0, y = 0, z = 0]: number[],
  m: mat4 | undefined,
  to: Float64Array,
  at: number,
) {
  for (let d = 0; d < 3; ++d)
    to[at + d] = m
      ? (m[d] as number) * x +
        (m[4 + d] as number) * y +
        (m[8 + d] as number) * z +
        (m[12 + d] as number)
      : ([x, y, z][d] as number);
}

/**
 * Writes a normal as it is on the placed surface, by the cofactors of the matrix. It faces outwards
 * as before, even where the placement mirrors.
 */
export function putNormal(
  normal: number[],
  { matrix: m, isMirrored }: Placement,
  to: Float64Array,
  at: number,
): void {
  if (!m) {
    to.set(normal, at);
    return;
  }
  const [x, y, z] = [0, 4, 8].map((i) => [m[i], m[i + 1], m[i + 2]] as Point) as [
    Point,
    Point,
    Point,
  ];
  const sign = isMirrored ? -1 : 1;
  [cross(y, z), cross(z, x), cross(x, y)].forEach((column, k) => {
    for (let d = 0; d < 3; ++d)
      (to[at + d] as number) += sign * (column[d] as number) * (normal[k] as number);
  });
}
