// How a layout looks to the people who use it. Lengths are on the surface, over the root of its
// area, so that sizes do not matter.
//
//   charts     number of charts
//   seam       outlines of charts: a cut counts on both sides, a border once
//   smooth     cuts along edges that bend by less than 15 degrees: nothing hides them
//   flat       cuts along edges that do not bend: within a flat region
//   crease     share of the length of cuts along edges that bend by 30 degrees or more
//   exposed    cuts, weighted by the share of the sky that they see
//   axis       share of outlines, in the layout, within 1 degree of u or v
//   upright    |cos| between v and the image of the mesh's up direction, mean over charts by area;
//              charts that lie flat are left out
//   thin       share of charts narrower than 8 texels at 1024, if charts filled the square
//   small      share of charts below 1/1000 of the surface
//   sd         symmetric Dirichlet energy / 4 at equal total area
//   stretched  share of the surface where one direction is stretched 1.25 times as much as another

import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { chartedLayout, cross, dot, lengthOf, minus } from './charted-layout.mjs';

const SMOOTH = 15;
const CREASE = 30;
/** As far as coordinates with six digits can tell. */
const FLAT = 0.1;
const LEVEL = Math.sin(Math.PI / 180);
/** Charts whose up direction keeps less of its length than this lie flat. */
const STANDING = 0.3;
const THIN_TEXELS = 8;
const TEXELS = 1024;
const SMALL = 1 / 1000;
/** Triangles below this share of the area have no shape to speak of. */
const VANISHING = 1e-14;
const MOST_ENERGY = 1e3;
const STRETCHED = 1.25;

const RAYS = 48;
/** Rays closer to the surface than this meet its own facets. */
const LEAST_RISE = 0.05;
/** Where rays start, over the surface, relative to the size of the mesh. */
const LIFT = 1e-4;

const total = (items, numberOf) => items.reduce((sum, item) => sum + numberOf(item), 0);
const spanOf = ({ uv: [p, q] }) => [q[0] - p[0], q[1] - p[1]];
const uvLength = (side) => Math.hypot(...spanOf(side));

/** Evenly spread directions. */
const SKY = Array.from({ length: RAYS }, (_, i) => {
  const z = 1 - (2 * i + 1) / RAYS;
  const r = Math.sqrt(1 - z * z);
  const turn = i * Math.PI * (3 - Math.sqrt(5));
  return [r * Math.cos(turn), r * Math.sin(turn), z];
});

/** A function of a point and a normal: the share of the sky above that the surface does not hide. */
function skyOver(triangles) {
  const geometry = new BufferGeometry();
  const xyz = triangles.flatMap((triangle) => triangle.xyz.flat());
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(xyz), 3));
  const tree = new MeshBVH(geometry);
  geometry.computeBoundingBox();
  const lift = LIFT * geometry.boundingBox.getSize(new Vector3()).length();
  const ray = new Ray();
  return (point, normal) => {
    ray.origin.set(...point.map((x, d) => x + lift * normal[d]));
    let [seen, all] = [0, 0];
    for (const direction of SKY) {
      const rise = dot(direction, normal);
      if (rise < LEAST_RISE) continue;
      all += rise;
      ray.direction.set(...direction);
      if (!tree.raycastFirst(ray, DoubleSide)) seen += rise;
    }
    return all > 0 ? seen / all : 0;
  };
}

function exposedLength({ triangles, cuts }) {
  if (cuts.length === 0) return 0;
  const skyAt = skyOver(triangles);
  return total(cuts, ({ a, b, length, sides }) => {
    const [n, m] = sides.map((side) => triangles[side.triangle].normal);
    const sum = n.map((x, d) => x + m[d]);
    const size = lengthOf(sum) || 1;
    const middle = a.map((x, d) => (x + b[d]) / 2);
    return (
      length *
      skyAt(
        middle,
        sum.map((x) => x / size),
      )
    );
  });
}

/**
 * The map from the surface to the layout, in a frame of the triangle: the frame's directions x, y
 * and their images, with lengths of the layout divided by `scale`.
 */
function mapOf({ xyz: [a, b, c], uv, normal }, scale) {
  const [first, second] = [minus(b, a), minus(c, a)];
  const length = lengthOf(first);
  const x = first.map((t) => t / length);
  const y = cross(normal, x);
  const [along, across] = [dot(second, x), dot(second, y)];
  const [p, q] = [1, 2].map((i) => [0, 1].map((d) => (uv[i][d] - uv[0][d]) / scale));
  const imageX = p.map((t) => t / length);
  const imageY = q.map((t, d) => (t - imageX[d] * along) / across);
  return { x, y, imageX, imageY };
}

function distortionOf({ imageX, imageY }) {
  const squares = total([...imageX, ...imageY], (t) => t * t);
  const area = Math.abs(imageX[0] * imageY[1] - imageX[1] * imageY[0]);
  // Of the singular values: their sum and difference.
  const sum = Math.sqrt(squares + 2 * area);
  const difference = Math.sqrt(Math.max(0, squares - 2 * area));
  return {
    energy: Math.min(MOST_ENERGY, (squares * (1 + 1 / (area * area))) / 4),
    ratio: (sum + difference) / (sum - difference),
  };
}

/** sd, stretched and upright, from triangles that have a shape. */
function shapesOf({ triangles, charts }, up) {
  const surface = total(triangles, (t) => t.area);
  const uvSurface = total(triangles, (t) => t.uvArea);
  const scale = Math.sqrt(uvSurface / surface);
  let [energy, weight, stretched] = [0, 0, 0];
  const ups = Array.from({ length: charts }, () => [0, 0]);
  for (const triangle of triangles) {
    const { area, uvArea, chart } = triangle;
    if (area <= VANISHING * surface || uvArea <= VANISHING * uvSurface) continue;
    const map = mapOf(triangle, scale);
    const distortion = distortionOf(map);
    energy += area * distortion.energy;
    weight += area;
    if (distortion.ratio > STRETCHED) stretched += area;
    const [alongX, alongY] = [dot(up, map.x), dot(up, map.y)];
    for (const d of [0, 1])
      ups[chart][d] += area * (alongX * map.imageX[d] + alongY * map.imageY[d]);
  }
  return { sd: energy / weight, stretched: stretched / surface, ups };
}

function byChart({ triangles, charts, rims }) {
  const out = Array.from({ length: charts }, () => ({ area: 0, uvArea: 0, perimeter: 0 }));
  for (const { chart, area, uvArea } of triangles) {
    out[chart].area += area;
    out[chart].uvArea += uvArea;
  }
  for (const side of rims) out[triangles[side.triangle].chart].perimeter += uvLength(side);
  return out;
}

function uprightness(charts, ups) {
  let [standing, upright] = [0, 0];
  for (const [i, { area }] of charts.entries()) {
    const length = Math.hypot(...ups[i]);
    if (length <= STANDING * area) continue;
    standing += area;
    upright += (area * Math.abs(ups[i][1])) / length;
  }
  return standing > 0 ? upright / standing : 1;
}

function isLevel(side) {
  const [u, v] = spanOf(side).map(Math.abs);
  return Math.min(u, v) <= LEVEL * uvLength(side);
}

/** The looks of what chartedLayout found. */
export function looksOf(charted, { up = [0, 1, 0], withExposed = true } = {}) {
  const { triangles, cuts, borders, rims } = charted;
  const surface = total(triangles, (t) => t.area);
  const uvSurface = total(triangles, (t) => t.uvArea);
  const root = Math.sqrt(surface);
  const charts = byChart(charted);
  const lengthWhere = (isMeant) => total(cuts.filter(isMeant), (cut) => cut.length);
  const cut = lengthWhere(() => true);
  const borderLength = total(borders, ({ xyz: [a, b] }) => lengthOf(minus(b, a)));
  const isThin = ({ perimeter, uvArea }) =>
    perimeter > 0 && ((2 * uvArea) / perimeter) * TEXELS < THIN_TEXELS * Math.sqrt(uvSurface);
  const { sd, stretched, ups } = shapesOf(charted, up);
  return {
    charts: charted.charts,
    seam: (borderLength + total(cuts, ({ length, sides }) => length * sides.length)) / root,
    smooth: lengthWhere(({ bend }) => bend < SMOOTH) / root,
    flat: lengthWhere(({ bend }) => bend < FLAT) / root,
    crease: cut > 0 ? lengthWhere(({ bend }) => bend >= CREASE) / cut : 1,
    exposed: withExposed ? exposedLength(charted) / root : undefined,
    axis: rims.length > 0 ? total(rims.filter(isLevel), uvLength) / total(rims, uvLength) : 1,
    upright: uprightness(charts, ups),
    thin: charts.filter(isThin).length / charts.length,
    small: charts.filter(({ area }) => area < SMALL * surface).length / charts.length,
    sd,
    stretched,
  };
}

/** The looks of `{ positions, texcoords, faces }`, as parseObj reads it. */
export const looksOfLayout = (layout, options) => looksOf(chartedLayout(layout), options);
