import { crossings } from '../mesh/crossings';
import { boundingBox, perCorner } from '../mesh/mesh';
import { tileFrames, tileGrid } from '../mesh/tiles';
import { FLAT_FRAME, type LayoutDrawing } from '../model/drawing';
import { cornersOfCharts, type FlatPicture } from './picture';

/** The most crossings to mark; more would only be a red blot. */
const MOST_MARKS = 500;

/** A layout in the plane. */
export function drawLayout(picture: FlatPicture, chartCount: number): LayoutDrawing {
  const { mesh, edges, tightened, resisting, chartColors, charts, tiles = 0 } = picture;
  const { min, max } = extentOf(picture, chartCount);
  const unit = Math.max(max[0] - min[0], max[1] - min[1]) || 1;
  const middle: [number, number] = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
  const toPlane = (uv: Float64Array) => placed(uv, middle, unit);
  const plane = toPlane(mesh.uv);
  const frames = tileFrames(tiles);
  // For an atlas, the report says whether charts cross.
  const crossed = chartColors ? new Float64Array() : crossings(mesh.uv, edges, MOST_MARKS);
  return {
    position: trianglesIn(plane, picture, chartCount),
    edges: perCorner(plane, 3, edges),
    resisting: perCorner(plane, 3, resisting),
    dots: perCorner(plane, 3, tightened),
    rings: toPlane(crossed),
    tileSides: perCorner(toPlane(frames.points), 3, frames.sides),
    tiles,
    size: [(max[0] - min[0]) / unit, (max[1] - min[1]) / unit],
    middle,
    unit,
    isOfFile: picture.isOfFile ?? false,
    frames: charts ? chartFrames(plane, mesh.indices, charts, chartCount) : new Float32Array(),
  };
}

/** The part of uv that is shown: all tiles, and what a file has beside them. */
function extentOf({ mesh, charts, tiles = 0, isOfFile }: FlatPicture, chartCount: number) {
  const grid = { min: [0, 0], max: tileGrid(tiles) };
  if (tiles && !isOfFile) return grid;
  if (!isOfFile || !charts) return boundingBox(mesh.uv, 2, mesh.indices);
  const { min, max } = boundingBox(mesh.uv, 2, cornersOfCharts(mesh.indices, charts, chartCount));
  return {
    min: grid.min.map((low, d) => Math.min(low, min[d])),
    max: grid.max.map((high, d) => Math.max(high, max[d])),
  };
}

/** A triangle of a file that has no uv is nowhere. */
function trianglesIn(
  plane: Float32Array,
  { mesh, charts, isOfFile }: FlatPicture,
  chartCount: number,
): Float32Array {
  const corners = perCorner(plane, 3, mesh.indices);
  if (isOfFile)
    charts?.forEach((chart, f) => {
      if (chart >= chartCount) corners.fill(0, 9 * f, 9 * f + 9);
    });
  return corners;
}

/** Converts uv, 2 numbers per point, to the plane that is drawn, 3 per point. */
function placed(uv: Float64Array, middle: [number, number], unit: number): Float32Array {
  const plane = new Float32Array((uv.length / 2) * 3);
  for (let i = 0; i < uv.length / 2; ++i)
    for (let d = 0; d < 2; ++d) plane[3 * i + d] = (uv[2 * i + d] - middle[d]) / unit;
  return plane;
}

/** `FLAT_FRAME` of each chart. */
function chartFrames(
  plane: Float32Array,
  indices: Uint32Array,
  charts: Uint32Array,
  chartCount: number,
): Float32Array {
  const { size, low, high } = FLAT_FRAME;
  const frames = new Float32Array(size * chartCount);
  for (let i = 0; i < frames.length; i += size) {
    frames.fill(Infinity, i + low, i + low + 2);
    frames.fill(-Infinity, i + high, i + high + 2);
  }
  for (let c = 0; c < indices.length; ++c) {
    const i = size * charts[Math.floor(c / 3)];
    if (i >= frames.length) continue;
    for (let d = 0; d < 2; ++d) {
      const x = plane[3 * indices[c] + d];
      if (x < frames[i + low + d]) frames[i + low + d] = x;
      if (x > frames[i + high + d]) frames[i + high + d] = x;
    }
  }
  return frames;
}
