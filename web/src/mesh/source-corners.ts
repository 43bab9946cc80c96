/** Faces of a file: the corners of face f are those from `offsets[f]` up to `offsets[f + 1]`. */
export interface FaceCorners {
  offsets: ArrayLike<number>;
  /** The vertex of each corner. */
  vertices: ArrayLike<number>;
}

export const NO_CORNER = -1;

/**
 * For each corner of each triangle, the corner of the file's face that it came from; NO_CORNER if
 * the face has no corner at that vertex. A layout has the same triangles with the same corners.
 */
export function sourceCorners(
  { indices, faces }: { indices: Uint32Array; faces?: Uint32Array },
  { offsets, vertices }: FaceCorners,
): Int32Array {
  const corners = new Int32Array(indices.length).fill(NO_CORNER);
  for (let c = 0; c < indices.length; ++c) {
    const triangle = Math.floor(c / 3);
    const face = faces ? faces[triangle] : triangle;
    for (let i = offsets[face]; i < offsets[face + 1]; ++i) {
      if (vertices[i] !== indices[c]) continue;
      corners[c] = i;
      break;
    }
  }
  return corners;
}

/**
 * For each corner of a layout's triangles, the corner of the mesh with the same vertex in the same
 * face, as a number from 1. Undefined if all are the same: polygons may be cut into other triangles.
 */
export function meshCorners(
  { indices, faces }: { indices: Uint32Array; faces?: Uint32Array },
  layout: { indices: Uint32Array; vertexMap: Uint32Array },
): Float32Array | undefined {
  if (!faces || faces.length !== layout.indices.length / 3) return undefined;
  const corners = new Float32Array(indices.length);
  let isSame = true;
  for (let from = 0, to = 0; from < indices.length; from = to) {
    while (to < indices.length && faces[to / 3] === faces[from / 3]) to += 3;
    for (let c = from; c < to; ++c) {
      const vertex = layout.vertexMap[layout.indices[c]];
      let same = from;
      while (same < to && indices[same] !== vertex) ++same;
      corners[c] = (indices[c] === vertex || same === to ? c : same) + 1;
      if (corners[c] !== c + 1) isSame = false;
    }
  }
  return isSame ? undefined : corners;
}
