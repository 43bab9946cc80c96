// OBJ files with materials, and the colours that their textures have at points of them.

import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { parsePng } from './png.mjs';
import { texelAt } from './textured.mjs';

/** The text of an OBJ of parts as those of texturedGlb, whose `material` is a name. */
export function texturedObj(library, parts) {
  const lines = [`mtllib ${library}`];
  let first = 1;
  for (const { positions, uv, triangles, material } of parts) {
    lines.push(`usemtl ${material}`);
    for (const p of positions) lines.push(`v ${p.join(' ')}`);
    for (const [u, v] of uv) lines.push(`vt ${u} ${1 - v}`);
    for (const face of triangles)
      lines.push(`f ${face.map((v) => `${first + v}/${first + v}`).join(' ')}`);
    first += positions.length;
  }
  return `${lines.join('\n')}\n`;
}

/** Lines of the material files of an OBJ: by the name of a material, a list of [keyword, words]. */
function materialsOf(lines, folder) {
  const out = new Map();
  for (const [keyword, name] of lines.map((line) => line.split(/\s+/))) {
    if (keyword !== 'mtllib') continue;
    let own;
    for (const text of readFileSync(join(folder, name), 'utf8').split('\n')) {
      const words = text.trim().split(/\s+/);
      if (words[0] === 'newmtl') {
        own = [];
        out.set(words[1], own);
      } else own?.push(words);
    }
  }
  return out;
}

const numbersAfter = (words, option, usual) => {
  const at = words.indexOf(option);
  return at < 0 ? usual : [Number(words[at + 1]), Number(words[at + 2])];
};

/**
 * For an OBJ of triangles: a function of the keyword of a map, a triangle and weights of its corners;
 * its result is undefined if the material has no such map. Also `words(keyword, triangle)`.
 */
export function objSampler(path) {
  const lines = readFileSync(path, 'utf8').split('\n');
  const materials = materialsOf(lines, dirname(path));
  const images = new Map();
  const imageOf = (name) => {
    if (!images.has(name)) images.set(name, parsePng(readFileSync(join(dirname(path), name))));
    return images.get(name);
  };
  const texcoords = [];
  const faces = [];
  let material;
  for (const [keyword, ...words] of lines.map((line) => line.split(/\s+/))) {
    if (keyword === 'vt') texcoords.push(words.map(Number));
    if (keyword === 'usemtl') material = words[0];
    if (keyword === 'f')
      faces.push({ material, texcoords: words.map((word) => Number(word.split('/')[1]) - 1) });
  }
  const words = (keyword, t) =>
    materials.get(faces[t].material)?.find(([word]) => word === keyword);
  const sample = (keyword, t, weights, isColour = false) => {
    const map = words(keyword, t);
    if (!map) return undefined;
    const scale = numbersAfter(map, '-s', [1, 1]);
    const offset = numbersAfter(map, '-o', [0, 0]);
    const [u, v] = [0, 1].map(
      (d) =>
        offset[d] +
        scale[d] * faces[t].texcoords.reduce((sum, i, k) => sum + weights[k] * texcoords[i][d], 0),
    );
    return texelAt(imageOf(map.at(-1)), [u, 1 - v], { isColour });
  };
  return { sample, words, count: faces.length };
}

/**
 * Of an OBJ of triangles in planes z = 0: the direction of x in its layout at a triangle, as the
 * cosine and the sine of its angle.
 */
export function directionOfX(path, triangle) {
  const lines = readFileSync(path, 'utf8')
    .split('\n')
    .map((line) => line.split(/\s+/));
  const rows = (word) => lines.filter(([first]) => first === word).map(([, ...rest]) => rest);
  const [a, b, c] = rows('f')[triangle].map((corner) => {
    const [p, t] = corner.split('/').map(Number);
    return { p: rows('v')[p - 1].map(Number), t: rows('vt')[t - 1].map(Number) };
  });
  const [e, f] = [b, c].map(({ p, t }) => [0, 1].map((d) => [p[d] - a.p[d], t[d] - a.t[d]]));
  const area = e[0][0] * f[1][0] - e[1][0] * f[0][0];
  const x = [0, 1].map((d) => (e[d][1] * f[1][0] - f[d][1] * e[1][0]) / area);
  return x.map((value) => value / Math.hypot(...x));
}
