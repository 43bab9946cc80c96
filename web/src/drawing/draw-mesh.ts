import { faultColor } from '../colors/fault-colors';
import { checkerCells, inCells } from '../mesh/checker';
import { areaVectors, facing, perCorner, toCorners, vertexNormals } from '../mesh/mesh';
import { toUnitSphere } from '../mesh/unit-sphere';
import { type Drawing, FRAME, type MeshDrawing, type TriangleMarks } from '../model/drawing';
import { axesOf, frontOf } from './front';
import { heatOfCorners } from './heat';
import { farthest, outline } from './outline';
import type { FlatPicture, Picture } from './picture';

/** Draws a mesh that was opened. */
export function drawMesh(picture: Picture): Drawing {
  const { mesh } = picture;
  const unit = toUnitSphere(mesh);
  const areas = areaVectors(mesh);
  const front = frontOf(facing(mesh, areas));
  const first = {
    front,
    outline: outline(unit, mesh.indices, axesOf(front)),
    hull: farthest(unit, mesh.indices),
  };
  const normals = vertexNormals(mesh, areas);
  return { mesh: { ...surface({ normals, ...picture }, unit), first } };
}

export function drawFlatMesh(picture: FlatPicture, chartCount: number): MeshDrawing {
  const { mesh, tightened, charts } = picture;
  const unit = toUnitSphere(mesh);
  const cells = checkerCells(mesh, picture.sizes);
  return {
    ...surface(picture, unit),
    uv: perCorner(inCells(mesh.uv, cells), 2, mesh.indices),
    cells,
    dots: perCorner(unit, 3, tightened),
    frames: charts
      ? chartFrames({ positions: unit, indices: mesh.indices }, charts, chartCount)
      : new Float32Array(),
  };
}

export function drawMarks(picture: FlatPicture): TriangleMarks {
  const { heat, mesh, charts, chartColors, source, faults } = picture;
  const none = new Float32Array(mesh.indices.length / 3);
  return {
    heat: heatOfCorners(heat.places),
    chart: toCorners(charts && chartColors ? colorsOf(charts, chartColors, faults) : none),
    piece: toCorners(charts ?? none),
    ...(source && { source }),
  };
}

/** The number of the colour of each triangle: of what is wrong with it or of its chart; 0 where it has none. */
function colorsOf(
  charts: Uint32Array,
  chartColors: Float32Array,
  faults?: Uint8Array,
): Float32Array {
  const colors = new Float32Array(charts.length);
  for (let f = 0; f < charts.length; ++f)
    if (charts[f] < chartColors.length)
      colors[f] = faultColor(faults?.[f] ?? 0) ?? chartColors[charts[f]];
  return colors;
}

function surface(
  { mesh, edges, normals = vertexNormals(mesh) }: Picture,
  unit: Float32Array,
): MeshDrawing {
  return {
    position: perCorner(unit, 3, mesh.indices),
    normal: perCorner(normals, 3, mesh.indices),
    edges: perCorner(unit, 3, edges),
    dots: new Float32Array(),
    frames: new Float32Array(),
  };
}

/** `FRAME` of each chart, if there are any. */
function chartFrames(
  mesh: { positions: Float32Array; indices: Uint32Array },
  charts: Uint32Array,
  chartCount: number,
): Float32Array {
  const { positions, indices } = mesh;
  const frames = new Float32Array(FRAME.size * chartCount);
  for (let i = 0; i < frames.length; i += FRAME.size) {
    frames.fill(Infinity, i + FRAME.low, i + FRAME.low + 3);
    frames.fill(-Infinity, i + FRAME.high, i + FRAME.high + 3);
  }
  const areas = areaVectors(mesh);
  for (let c = 0; c < indices.length; ++c) {
    const i = FRAME.size * charts[Math.floor(c / 3)];
    if (i >= frames.length) continue;
    for (let d = 0; d < 3; ++d) {
      const x = positions[3 * indices[c] + d];
      if (x < frames[i + FRAME.low + d]) frames[i + FRAME.low + d] = x;
      if (x > frames[i + FRAME.high + d]) frames[i + FRAME.high + d] = x;
    }
    if (c % 3 !== 0) continue;
    for (let d = 0; d < 3; ++d) frames[i + FRAME.area + d] += areas[c + d];
    frames[i + FRAME.total] += Math.hypot(areas[c], areas[c + 1], areas[c + 2]);
  }
  return frames;
}
