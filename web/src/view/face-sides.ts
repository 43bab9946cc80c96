import type { FlatDrawing } from '../model/drawing';

const CORNERS = [
  [0, 1],
  [1, 2],
  [2, 0],
];

/** xyz of both ends of each side of some triangles of the mesh, in both views. */
export interface FaceSides {
  mesh: Float32Array;
  layout: Float32Array;
}

export const NO_SIDES: FaceSides = { mesh: new Float32Array(), layout: new Float32Array() };

export function faceSides({ mesh, layout, marks }: FlatDrawing, triangles: number[]): FaceSides {
  const drawn = marks.source ? drawnAs(marks.source, triangles) : triangles;
  return { mesh: sides(mesh.position, drawn), layout: sides(layout.position, drawn) };
}

/** Where triangles of the mesh are among those that are drawn. `source`: as in TriangleMarks. */
function drawnAs(source: Float32Array, triangles: number[]): number[] {
  const wanted = new Set(triangles);
  const drawn: number[] = [];
  for (let c = 0; c < source.length; c += 3)
    if (wanted.has(Math.floor((source[c] - 1) / 3))) drawn.push(c / 3);
  return drawn;
}

function sides(points: Float32Array, triangles: number[]): Float32Array {
  const out = new Float32Array(18 * triangles.length);
  triangles.forEach((t, i) => {
    CORNERS.flat().forEach((corner, k) => {
      const at = 9 * t + 3 * corner;
      out.set(points.subarray(at, at + 3), 18 * i + 3 * k);
    });
  });
  return out;
}
