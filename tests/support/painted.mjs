// Painted meshes: a square of 4 x 4 quads in the plane z = 0, and pictures for it.

import { accessor, addMesh, emptyDocument } from './gltf.mjs';
import { madePng } from './made-png.mjs';

export const RED = [230, 40, 40];
export const GREEN = [40, 200, 60];
export const BLUE = [40, 80, 230];
export const YELLOW = [230, 210, 40];

const N = 4;

/** `positions`, `uv` (v upwards) and `quads` of a square from `left` to `left + 1`. */
export function square(left = 0) {
  const positions = [];
  const uv = [];
  const quads = [];
  for (let j = 0; j <= N; j++)
    for (let i = 0; i <= N; i++) {
      positions.push([left + i / N, j / N, 0]);
      uv.push([i / N, j / N]);
      const at = j * (N + 1) + i;
      if (i < N && j < N) quads.push([at, at + 1, at + N + 2, at + N + 1]);
    }
  return { positions, uv, quads };
}

/** Red and green above blue and yellow. */
export const fourColors = (size = 32) =>
  madePng(
    size,
    size,
    (x, y) =>
      [
        [RED, GREEN],
        [BLUE, YELLOW],
      ][y < size / 2 ? 0 : 1][x < size / 2 ? 0 : 1],
  );

export const oneColor = (color, size = 8) => madePng(size, size, () => color);

/** A document with squares beside each other; each has a material of its own, made by `paint`. */
export function paintedDocument(...paints) {
  const document = emptyDocument();
  paints.forEach((paint, i) => {
    const { positions, uv, quads } = square(i);
    const material = document.createMaterial(`material ${i}`);
    const primitive = document
      .createPrimitive()
      .setAttribute('POSITION', accessor(document, 'VEC3', Float32Array.from(positions.flat())))
      .setAttribute(
        'TEXCOORD_0',
        accessor(document, 'VEC2', Float32Array.from(uv.flatMap(([u, v]) => [u, 1 - v]))),
      )
      .setIndices(
        accessor(
          document,
          'SCALAR',
          Uint16Array.from(quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d])),
        ),
      )
      .setMaterial(material);
    paint(document, material, primitive);
    addMesh(document, `square ${i}`, primitive);
  });
  return document;
}

export const textured = (name, image) => (document, material) =>
  material.setBaseColorTexture(
    document.createTexture(name).setImage(image).setMimeType('image/png').setURI(`${name}.png`),
  );
