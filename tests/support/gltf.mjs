// glTF-Transform documents for tests, and ways to inspect them without the program.

import assert from 'node:assert/strict';
import { Document, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import validator from 'gltf-validator';
import { randomNumbers } from './disks.mjs';

export const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);

/** A document with one buffer and one scene. */
export function emptyDocument() {
  const document = new Document();
  document.createBuffer();
  document.createScene();
  return document;
}

/** An accessor of a list of rows or of a typed array. */
export function accessor(document, type, array, isNormalized = false) {
  return document
    .createAccessor()
    .setType(type)
    .setArray(array)
    .setNormalized(isNormalized)
    .setBuffer(document.getRoot().listBuffers()[0]);
}

const TRIANGLES = ([a, b, c, d]) => (d === undefined ? [a, b, c] : [a, b, c, a, c, d]);

/** Triangles of a surface of surfaces.mjs. */
export const indicesOf = ({ faces }) => faces.flatMap(TRIANGLES);

export const positionsOf = (document, { positions }) =>
  accessor(document, 'VEC3', Float32Array.from(positions.flat()));

/** A primitive of a surface, with positions and indices of the given kind. */
export function primitiveOf(document, surface, Kind = Uint16Array) {
  return document
    .createPrimitive()
    .setAttribute('POSITION', positionsOf(document, surface))
    .setIndices(accessor(document, 'SCALAR', Kind.from(indicesOf(surface))));
}

/** Puts primitives into the scene as one mesh of one node. */
export function addMesh(document, name, ...primitives) {
  const mesh = document.createMesh(name);
  for (const primitive of primitives) mesh.addPrimitive(primitive);
  const node = document.createNode(name).setMesh(mesh);
  document.getRoot().listScenes()[0].addChild(node);
  return { mesh, node };
}

const SIZES = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

/** Random rows; integers cover the whole range of their type. */
export function randomRows(document, type, Kind, count, { seed = 1, normalized = false } = {}) {
  const random = randomNumbers(seed);
  const most = Kind === Float32Array ? 1 : 2 ** (8 * Kind.BYTES_PER_ELEMENT) - 1;
  const values = Array.from({ length: SIZES[type] * count }, () => random() * most);
  return accessor(document, type, Kind.from(values), normalized);
}

/** The document as read back from its file. */
export async function reread(document) {
  return io.readBinary(await io.writeBinary(document));
}

/** Fails with what Khronos' validator says about the document's file. */
export async function assertValidFile(document) {
  const { issues } = await validator.validateBytes(await io.writeBinary(document));
  const errors = issues.messages.filter(({ severity }) => severity === 0);
  assert.deepEqual(errors, []);
}

export const primitivesOf = (document) =>
  document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives());

/** The triangles of a primitive that consists of triangles, a strip or a fan. */
export function trianglesOf(primitive) {
  const count = primitive.getAttribute('POSITION').getCount();
  const v = primitive.getIndices()?.getArray() ?? Array.from({ length: count }, (_, i) => i);
  const mode = primitive.getMode();
  const all = Array.from({ length: mode === 4 ? v.length / 3 : v.length - 2 }, (_, i) => {
    if (mode === 4) return [v[3 * i], v[3 * i + 1], v[3 * i + 2]];
    if (mode === 6) return [v[0], v[i + 1], v[i + 2]];
    return i % 2 ? [v[i + 1], v[i], v[i + 2]] : [v[i], v[i + 1], v[i + 2]];
  });
  return mode === 4 ? all : all.filter((triangle) => new Set(triangle).size === 3);
}

function row(attribute, i) {
  const size = attribute.getElementSize();
  return [...attribute.getArray().subarray(size * i, size * (i + 1))];
}

/**
 * Asserts that every corner has every attribute it had, as it was stored, that rows keep their
 * numbers, and that only necessary rows are added.
 */
export function assertSameButTexcoord(after, before, semantic = 'TEXCOORD_0') {
  const [to, from] = [primitivesOf(after), primitivesOf(before)];
  assert.equal(to.length, from.length);
  for (const [p, primitive] of to.entries()) {
    const was = from[p];
    const [triangles, old] = [trianglesOf(primitive), trianglesOf(was)];
    assert.equal(triangles.length, old.length, `triangles of primitive ${p}`);
    const owners = [
      [primitive, was],
      ...primitive.listTargets().map((target, i) => [target, was.listTargets()[i]]),
    ];
    assert.equal(primitive.listTargets().length, was.listTargets().length);
    assert.equal(primitive.getMaterial()?.getName(), was.getMaterial()?.getName());
    for (const [owner, oldOwner] of owners)
      for (const name of oldOwner.listSemantics()) {
        if (name === semantic && owner === primitive) continue;
        const place = `${name} of primitive ${p}`;
        const [a, b] = [owner.getAttribute(name), oldOwner.getAttribute(name)];
        assert.ok(a, place);
        assert.equal(a.getType(), b.getType(), place);
        assert.equal(a.getComponentType(), b.getComponentType(), place);
        assert.equal(a.getNormalized(), b.getNormalized(), place);
        assert.deepEqual(
          a.getArray().slice(0, b.getArray().length),
          b.getArray(),
          `${place}: rows keep their numbers`,
        );
        for (const [t, triangle] of triangles.entries())
          for (const [k, vertex] of triangle.entries())
            assert.deepEqual(row(a, vertex), row(b, old[t][k]), `${place}, triangle ${t}`);
      }
  }
}

/**
 * The triangles of the atlas, [[u, v], ...] with v upwards; `isMirrored` tells for which primitives
 * they run backwards.
 */
export function atlasOf(primitives, { texcoord = 0, isMirrored = () => false } = {}) {
  return primitives.flatMap((primitive) => {
    const uv = primitive.getAttribute(`TEXCOORD_${texcoord}`);
    return trianglesOf(primitive).map((triangle) => {
      const corners = triangle.map((vertex) => {
        const [u, v] = row(uv, vertex);
        return [u, 1 - v];
      });
      return isMirrored(primitive) ? corners.reverse() : corners;
    });
  });
}

/**
 * Sentences about triangles that are outside the unit square, flipped, or overlap at the middle of
 * a texel.
 */
export function flaws(triangles, texels = 1024) {
  const found = [];
  const owner = new Int32Array(texels * texels).fill(-1);
  for (const [t, [a, b, c]] of triangles.entries()) {
    const flat = [a, b, c].flat();
    if (!flat.every((x) => x >= 0 && x <= 1)) found.push(`triangle ${t} is outside: ${flat}`);
    if (!(cross(a, b, c) > 0)) found.push(`triangle ${t} is turned over or has no area`);
    const [us, vs] = [0, 1].map((d) => [a[d], b[d], c[d]].map((x) => x * texels));
    for (let y = Math.floor(Math.min(...vs)); y < Math.max(...vs); ++y)
      for (let x = Math.floor(Math.min(...us)); x < Math.max(...us); ++x) {
        const p = [(x + 0.5) / texels, (y + 0.5) / texels];
        if (!(cross(a, b, p) > 0 && cross(b, c, p) > 0 && cross(c, a, p) > 0)) continue;
        const texel = y * texels + x;
        if (owner[texel] >= 0) found.push(`triangles ${owner[texel]} and ${t} overlap at ${p}`);
        owner[texel] = t;
      }
  }
  return found;
}

export const cross = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
