// The texel density of each chart of an atlas, measured from its file.

import { chartsOf, parseObj } from './atlas.mjs';

const distance = (p, q) => Math.hypot(...p.map((x, d) => x - q[d]));

/** 0 where an angle is below 1e-9 for sure: such faces count as without area. */
const areaInSpace = ([a, b, c]) => {
  const [u, v] = [b, c].map((p) => p.map((x, d) => x - a[d]));
  const normal = [0, 1, 2].map(
    (d) => u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3],
  );
  const area = Math.hypot(...normal) / 2;
  return area > 2.5e-10 * longestOf([a, b, c]) ** 2 ? area : 0;
};

const longestOf = ([a, b, c]) => Math.max(distance(a, b), distance(b, c), distance(c, a));

/** The height is below a millionth of the longest side: such a face may be a line in the atlas. */
const isSliver = (points, area) => area < 5e-7 * longestOf(points) ** 2;

const areaInAtlas = ([a, b, c]) =>
  ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;

/** The texcoords of each side of a face. */
const sidesOf = (face) => face.map(([, t], k) => [t, face[(k + 1) % face.length][1]]);

/** Half the distance between neighbouring numbers in single precision, at the largest coordinate. */
const roundingOf = (texcoords) => {
  const most = texcoords.flat().reduce((m, x) => Math.max(m, Math.abs(x)), 1);
  return 2 ** (Math.ceil(Math.log2(most)) - 25);
};

/**
 * Of an OBJ text of triangles, per chart with area: { density, rounding, drawnOut }, in texels per
 * unit, where rounding is what single precision and slivers that became lines may cost of it, as a
 * share, and drawnOut how many times its outline is as long as on the surface.
 */
export function chartDensities(text, resolution) {
  const obj = parseObj(text);
  const { ofFace, count } = chartsOf(obj);
  const charts = Array.from({ length: count }, () => ({
    ...{ inSpace: 0, inAtlas: 0, inLines: 0 },
    ...{ outline: 0, outlineInSpace: 0 },
  }));
  const sides = new Set(obj.faces.flatMap(sidesOf).map(([a, b]) => `${a} ${b}`));
  for (const [f, face] of obj.faces.entries()) {
    const chart = charts[ofFace[f]];
    const uv = face.map(([, t]) => obj.texcoords[t]);
    const points = face.map(([v]) => obj.positions[v]);
    const own = areaInSpace(points);
    chart.inSpace += own;
    chart.inAtlas += areaInAtlas(uv);
    if (areaInAtlas(uv) === 0 && isSliver(points, own)) chart.inLines += own;
    sidesOf(face).forEach(([a, b], k) => {
      if (sides.has(`${b} ${a}`)) return;
      const [[from], [to]] = [face[k], face[(k + 1) % face.length]];
      chart.outline += distance(obj.texcoords[a], obj.texcoords[b]);
      chart.outlineInSpace += distance(obj.positions[from], obj.positions[to]);
    });
  }
  const step = roundingOf(obj.texcoords);
  return charts
    .filter(({ inSpace }) => inSpace > 0)
    .map(({ inSpace, inAtlas, inLines, outline, outlineInSpace }) => ({
      density: resolution * Math.sqrt(inAtlas / inSpace),
      rounding: (step * outline) / inAtlas + inLines / inSpace,
      drawnOut: outline / outlineInSpace / Math.sqrt(inAtlas / inSpace),
    }));
}
