// A closed mesh with a painted texture, made of nothing but numbers.

import { Document, WebIO } from '@gltf-transform/core';

const RIBS = 10;
const AROUND = 40;
/** Radius and height from the dent below to the end of the stem; the stem has no ribs. */
const PROFILE = [
  [0, -0.5],
  [0.14, -0.54],
  [0.34, -0.61],
  [0.56, -0.62],
  [0.76, -0.53],
  [0.91, -0.36],
  [0.99, -0.14],
  [1, 0.06],
  [0.95, 0.27],
  [0.83, 0.46],
  [0.65, 0.59],
  [0.46, 0.63],
  [0.3, 0.57],
  [0.2, 0.48],
  [0.14, 0.5],
  [0.11, 0.62],
  [0.1, 0.76],
  [0.12, 0.88],
  [0.11, 0.92],
  [0, 0.93],
];
/** The first row of the stem. */
const STEM = 14;
const SIZE = { width: 512, height: 256 };

/** How far along the profile each of its points is, from 0 to 1. */
function lengthsAlong(profile) {
  const sums = [0];
  for (let i = 1; i < profile.length; ++i) {
    const [a, b] = [profile[i - 1], profile[i]];
    sums.push(sums[i - 1] + Math.hypot(b[0] - a[0], b[1] - a[1]));
  }
  return sums.map((sum) => sum / sums.at(-1));
}

const ALONG = lengthsAlong(PROFILE);

/** 1 on a rib, 0 in a groove. */
const ribAt = (turn) => Math.abs(Math.sin(RIBS * Math.PI * turn)) ** 0.7;

/** A value between two of a list. */
function between(values, at) {
  const i = Math.min(values.length - 2, Math.floor(at));
  return values[i] + (at - i) * (values[i + 1] - values[i]);
}

const RADII = PROFILE.map(([radius]) => radius);
const HEIGHTS = PROFILE.map(([, height]) => height);

function pointAt(row, turn) {
  const [radius, height] = [between(RADII, row), between(HEIGHTS, row)];
  const isStem = row >= STEM;
  const r = radius * (isStem ? 1 : 0.88 + 0.12 * ribAt(turn));
  // The stem leans a little.
  const lean = isStem ? 0.5 * (height - 0.5) ** 2 : 0;
  const angle = 2 * Math.PI * turn;
  return [r * Math.sin(angle) + lean, height, -r * Math.cos(angle)];
}

/**
 * The first and the last column are the same places with other texture coordinates. `detail`: each side of a quad in as many parts.
 */
export function pumpkinMesh(detail = 1) {
  const [positions, texcoords, indices] = [[], [], []];
  const around = detail * AROUND;
  const at = (row, column) => row * (around + 1) + column;
  const last = detail * (PROFILE.length - 1);
  for (let row = 0; row <= last; ++row)
    for (let column = 0; column <= around; ++column) {
      positions.push(...pointAt(row / detail, (column % around) / around));
      texcoords.push(column / around, 1 - between(ALONG, row / detail));
    }
  for (let row = 0; row < last; ++row)
    for (let column = 0; column < around; ++column) {
      const [a, b] = [at(row, column), at(row, column + 1)];
      const [c, d] = [at(row + 1, column), at(row + 1, column + 1)];
      if (row > 0) indices.push(a, d, b);
      if (row < last - 1) indices.push(a, c, d);
    }
  return { positions, texcoords, indices };
}

/** Paints the texture on a canvas of a page; runs there. */
function paintInPage({ size: { width, height }, ribs, stem }) {
  const canvas = new OffscreenCanvas(width, height);
  const pen = canvas.getContext('2d');
  const skin = pen.createLinearGradient(0, 0, 0, height);
  for (const [stop, color] of [
    [stem, '#c8661a'],
    [stem + 0.25, '#ee8a22'],
    [0.7, '#e77817'],
    [1, '#a9500f'],
  ])
    skin.addColorStop(stop, color);
  pen.fillStyle = skin;
  pen.fillRect(0, 0, width, height);
  for (let rib = 0; rib <= ribs; ++rib) {
    const middle = (rib * width) / ribs;
    const groove = pen.createLinearGradient(middle - 14, 0, middle + 14, 0);
    groove.addColorStop(0, '#7c320000');
    groove.addColorStop(0.5, '#7c3200b0');
    groove.addColorStop(1, '#7c320000');
    pen.fillStyle = groove;
    pen.fillRect(middle - 14, 0, 28, height);
  }
  pen.fillStyle = '#5f7d32';
  pen.fillRect(0, 0, width, stem * height);
  const face = (points) => {
    pen.beginPath();
    for (const [x, y] of points) pen.lineTo(x * width, y * height);
    pen.closePath();
    pen.fill();
  };
  pen.fillStyle = '#3a1a08';
  for (const side of [-1, 1])
    face([
      [0.5 + side * 0.035, 0.46],
      [0.5 + side * 0.11, 0.46],
      [0.5 + side * 0.07, 0.36],
    ]);
  face([
    [0.48, 0.52],
    [0.52, 0.52],
    [0.5, 0.47],
  ]);
  face([
    [0.36, 0.55],
    [0.42, 0.6],
    [0.44, 0.57],
    [0.46, 0.615],
    [0.54, 0.615],
    [0.56, 0.57],
    [0.58, 0.6],
    [0.64, 0.55],
    [0.6, 0.66],
    [0.54, 0.69],
    [0.52, 0.655],
    [0.48, 0.655],
    [0.46, 0.69],
    [0.4, 0.66],
  ]);
  return canvas
    .convertToBlob({ type: 'image/jpeg', quality: 0.85 })
    .then((blob) => blob.arrayBuffer())
    .then((buffer) => Array.from(new Uint8Array(buffer)));
}

/** The texture as JPEG, painted by a browser. */
export async function pumpkinTexture(page) {
  const stem = 1 - (ALONG[STEM - 1] + ALONG[STEM]) / 2;
  return Uint8Array.from(await page.evaluate(paintInPage, { size: SIZE, ribs: RIBS, stem }));
}

/** The mesh with its texture as GLB. */
export async function pumpkinGlb(texture) {
  const { positions, texcoords, indices } = pumpkinMesh();
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type, array) =>
    document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const image = document.createTexture('skin').setImage(texture).setMimeType('image/jpeg');
  const material = document.createMaterial('skin').setBaseColorTexture(image);
  material.setMetallicFactor(0).setRoughnessFactor(0.6);
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions)))
    .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(texcoords)))
    .setIndices(accessor('SCALAR', Uint16Array.from(indices)))
    .setMaterial(material);
  const mesh = document.createMesh('pumpkin').addPrimitive(primitive);
  document.createScene().addChild(document.createNode('pumpkin').setMesh(mesh));
  return new WebIO().writeBinary(document);
}
