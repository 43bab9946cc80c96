// The light that the surfaces of a scene get from a sun and from the sky, texel by texel.

import * as THREE from 'three';
import { blockerOf } from './rays.mjs';

const SUN = new THREE.Vector3(0.5, 0.9, 0.55).normalize();
const SUN_COLOUR = [0.7, 0.64, 0.52];
const SKY_COLOUR = [0.32, 0.37, 0.45];
/** Rays begin a little above their surface. */
const ABOVE = 1e-3;

/**
 * Linear red, green and blue of `side` x `side` texels, rows from the top. `spread`: how far light
 * goes on beyond the charts, so that texels on their borders can be mixed.
 */
export function lightOn(meshes, { side, rays, spread }) {
  const triangles = meshes.flatMap(trianglesOf);
  const isBlocked = blockerOf(triangles.map(({ places }) => places.map((p) => p.toArray())));
  const directions = skyDirections(rays);
  const colours = new Float32Array(3 * side * side).fill(Number.NaN);
  for (const triangle of triangles)
    forTexels(triangle.uv, side, (x, y, weights) => {
      const at = (values) =>
        values.reduce((sum, p, k) => sum.addScaledVector(p, weights[k]), new THREE.Vector3());
      const normal = at(triangle.normals).normalize();
      const place = at(triangle.places).addScaledVector(normal, ABOVE);
      colours.set(lightAt(place, normal, directions, isBlocked), 3 * (y * side + x));
    });
  for (let i = 0; i < spread; ++i) grow(colours, side);
  return { side, colours: colours.map((x) => (Number.isNaN(x) ? 0 : x)) };
}

function lightAt(place, normal, directions, isBlocked) {
  const origin = place.toArray();
  const sun = Math.max(0, normal.dot(SUN));
  const direct = sun > 0 && !isBlocked(origin, SUN.toArray()) ? sun : 0;
  const turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), normal);
  const ray = new THREE.Vector3();
  const isFree = (direction) => {
    ray.copy(direction).applyQuaternion(turn);
    return ray.y > 0 && !isBlocked(origin, ray.toArray());
  };
  const sky = directions.filter(isFree).length / directions.length;
  return [0, 1, 2].map((c) => direct * SUN_COLOUR[c] + sky * SKY_COLOUR[c]);
}

/** Around +y, more of them where they count more: as many as the cosine says. */
function skyDirections(count) {
  const golden = Math.PI * (3 - Math.sqrt(5));
  return Array.from({ length: count }, (_, i) => {
    const square = (i + 0.5) / count;
    const radius = Math.sqrt(square);
    const [x, z] = [radius * Math.cos(golden * i), radius * Math.sin(golden * i)];
    return new THREE.Vector3(x, Math.sqrt(1 - square), z);
  });
}

/** Triangles in the world, with the normals and the light map coordinates of their corners. */
function trianglesOf({ mesh, geometry }) {
  mesh.updateWorldMatrix(true, false);
  const { position, normal, uv1 } = geometry.attributes;
  const toWorld = new THREE.Matrix3().getNormalMatrix(mesh.matrixWorld);
  const corners = [...geometry.index.array];
  return Array.from({ length: corners.length / 3 }, (_, i) => {
    const vertices = corners.slice(3 * i, 3 * i + 3);
    return {
      places: vertices.map((v) =>
        new THREE.Vector3().fromBufferAttribute(position, v).applyMatrix4(mesh.matrixWorld),
      ),
      normals: vertices.map((v) =>
        new THREE.Vector3().fromBufferAttribute(normal, v).applyMatrix3(toWorld).normalize(),
      ),
      uv: vertices.map((v) => [uv1.getX(v), 1 - uv1.getY(v)]),
    };
  });
}

/** Texels whose middle is in a triangle, with the weights of its corners there. */
function forTexels(uv, side, see) {
  const [a, b, c] = uv.map((point) => point.map((x) => x * side));
  const turn = (p, q, r) => (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  const area = turn(a, b, c);
  if (area === 0) return;
  const bounds = [0, 1].map((d) => {
    const values = [a[d], b[d], c[d]];
    return [Math.floor(Math.min(...values)), Math.min(side - 1, Math.floor(Math.max(...values)))];
  });
  for (let y = bounds[1][0]; y <= bounds[1][1]; ++y)
    for (let x = bounds[0][0]; x <= bounds[0][1]; ++x) {
      const middle = [x + 0.5, y + 0.5];
      const weights = [turn(b, c, middle), turn(c, a, middle), turn(a, b, middle)];
      if (weights.every((w) => w / area >= 0))
        see(
          x,
          y,
          weights.map((w) => w / area),
        );
    }
}

/** Texels beside known ones get the mean of those. */
function grow(colours, side) {
  const before = colours.slice();
  for (let y = 0; y < side; ++y)
    for (let x = 0; x < side; ++x) {
      const to = 3 * (y * side + x);
      if (!Number.isNaN(before[to])) continue;
      const [sum, count] = [[0, 0, 0], { known: 0 }];
      for (let j = Math.max(0, y - 1); j <= Math.min(side - 1, y + 1); ++j)
        for (let i = Math.max(0, x - 1); i <= Math.min(side - 1, x + 1); ++i) {
          const from = 3 * (j * side + i);
          if (Number.isNaN(before[from])) continue;
          ++count.known;
          for (let d = 0; d < 3; ++d) sum[d] += before[from + d];
        }
      if (count.known > 0)
        colours.set(
          sum.map((x) => x / count.known),
          to,
        );
    }
}
