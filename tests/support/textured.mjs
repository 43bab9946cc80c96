// Meshes with textures as GLB files, and the colours that their textures have at points of them.

import { elementsOf, GlbMaker, parseGltf, trianglesOf } from './glb.mjs';
import { parsePng } from './png.mjs';

const FLOATS = { positions: 'POSITION', normals: 'NORMAL', uv: 'TEXCOORD_0', uv1: 'TEXCOORD_1' };
const MORE = { tangents: 'TANGENT', colors: 'COLOR_0' };

/**
 * A GLB of one mesh with a primitive per part: lists of `positions`, `normals`, `uv` (v downwards)
 * and so on, `triangles` and the number of a `material`. `images` are the bytes of files.
 */
export function texturedGlb(parts, { images = [], ...json }) {
  const maker = new GlbMaker();
  const primitives = parts.map((part) => {
    const attributes = {};
    for (const [key, name] of Object.entries({ ...FLOATS, ...MORE })) {
      if (!part[key]) continue;
      const array = Float32Array.from(part[key].flat());
      attributes[name] = maker.accessor(array, `VEC${part[key][0].length}`, {
        box: key === 'positions',
        target: 34962,
      });
    }
    const indices = maker.accessor(Uint32Array.from(part.triangles.flat()), 'SCALAR', {
      target: 34963,
    });
    return { attributes, indices, ...(part.material !== undefined && { material: part.material }) };
  });
  Object.assign(maker.json, {
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives }],
    ...json,
  });
  if (images.length > 0)
    maker.json.images = images.map((bytes) => ({
      bufferView: maker.view(bytes),
      mimeType: 'image/png',
    }));
  return maker.glb();
}

/** A material whose colour is an image, for texturedGlb; `more` and `info` add to it and its texture. */
export const oneTexture = (image, more = {}, info = {}) => ({
  materials: [
    { name: 'wood', pbrMetallicRoughness: { baseColorTexture: { index: 0, ...info } }, ...more },
  ],
  textures: [{ source: 0 }],
  images: [image],
});

/** A cube of side 2: each side has a cell of its own of three by two in the image. */
export function texturedCube(material = 0) {
  const out = { positions: [], normals: [], uv: [], triangles: [], material };
  for (let side = 0; side < 6; side++) {
    const axis = side % 3;
    const sign = side < 3 ? 1 : -1;
    const normal = [0, 0, 0];
    normal[axis] = sign;
    const first = out.positions.length;
    for (const [a, b] of [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ]) {
      const position = [0, 0, 0];
      position[axis] = sign;
      position[(axis + 1) % 3] = (2 * a - 1) * sign;
      position[(axis + 2) % 3] = 2 * b - 1;
      out.positions.push(position);
      out.normals.push(normal);
      out.uv.push([(axis + 0.1 + 0.8 * a) / 3, ((side < 3 ? 0 : 1) + 0.1 + 0.8 * b) / 2]);
    }
    out.triangles.push([first, first + 1, first + 2], [first, first + 2, first + 3]);
  }
  return out;
}

const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
const WRAPS = {
  10497: (x, n) => ((x % n) + n) % n,
  33071: (x, n) => Math.min(Math.max(x, 0), n - 1),
  33648: (x, n) => {
    const at = ((x % (2 * n)) + 2 * n) % (2 * n);
    return at < n ? at : 2 * n - 1 - at;
  },
};

function transformed([u, v], { offset = [0, 0], rotation = 0, scale = [1, 1] } = {}) {
  const [x, y] = [u * scale[0], v * scale[1]];
  const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
  return [c * x + s * y + offset[0], -s * x + c * y + offset[1]];
}

/** The numbers from 0 to 1 of an image of parsePng at uv (v downwards), interpolated. */
export function texelAt(image, [u, v], { wrapS = 10497, wrapT = 10497, isColour = false } = {}) {
  const [x, y] = [u * image.width - 0.5, v * image.height - 0.5];
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const out = Array(image.channels).fill(0);
  for (const [dx, dy] of [
    [0, 0],
    [1, 0],
    [0, 1],
    [1, 1],
  ]) {
    const weight = (dx ? x - i : 1 - x + i) * (dy ? y - j : 1 - y + j);
    image
      .at(WRAPS[wrapS](i + dx, image.width), WRAPS[wrapT](j + dy, image.height))
      .forEach((value, d) => {
        out[d] += weight * (isColour && d < 3 ? linear(value / 255) : value / 255);
      });
  }
  return out;
}

/** The images of a GLB that are PNG, parsed; one at a time, when first needed. */
function imagesOf(gltf) {
  const parsed = new Map();
  return (i) => {
    if (!parsed.has(i)) {
      const { byteOffset = 0, byteLength } = gltf.json.bufferViews[gltf.json.images[i].bufferView];
      parsed.set(i, parsePng(gltf.buffer.subarray(byteOffset, byteOffset + byteLength)));
    }
    return parsed.get(i);
  };
}

/**
 * A function of a map (its path in the material), a triangle (of all primitives, in their order) and
 * weights of its corners: the numbers from 0 to 1 that the texture has there, interpolated.
 */
export function samplerOf(bytes) {
  const gltf = parseGltf(bytes);
  const imageAt = imagesOf(gltf);
  const { json } = gltf;
  const triangles = json.meshes.flatMap(({ primitives }) =>
    primitives.flatMap((primitive) =>
      trianglesOf(gltf, primitive).map((corners) => ({ primitive, corners })),
    ),
  );
  const elements = new Map();
  const uvOf = (primitive, set) => {
    const accessor = primitive.attributes[`TEXCOORD_${set}`];
    if (!elements.has(accessor)) elements.set(accessor, elementsOf(gltf, accessor));
    return elements.get(accessor);
  };
  const sample = (path, t, weights, isColour = false) => {
    const { primitive, corners } = triangles[t];
    const info = path.split('.').reduce((at, key) => at?.[key], json.materials[primitive.material]);
    if (!info) return undefined;
    const transform = info.extensions?.KHR_texture_transform;
    const uv = uvOf(primitive, transform?.texCoord ?? info.texCoord ?? 0);
    const at = [0, 1].map((d) => corners.reduce((sum, v, k) => sum + weights[k] * uv[v][d], 0));
    const texture = json.textures[info.index];
    const image = imageAt(texture.source);
    const { wrapS = 10497, wrapT = 10497 } = json.samplers?.[texture.sampler] ?? {};
    const [u, v] = transformed(at, transform);
    return texelAt(image, [u, v], { wrapS, wrapT, isColour });
  };
  return { sample, gltf, json, count: triangles.length };
}
