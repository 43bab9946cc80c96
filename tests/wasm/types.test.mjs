// The declarations in all kinds of projects: with and without those of browsers and Node, resolved
// the way Node and bundlers do it.

import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import ts from 'typescript';
import { ROOT } from './support/paths.mjs';

const ARRAYS = `
import { AbflatError, type Abflat, createAbflat, SAMPLE_NAMES, UNWRAP_DEFAULTS, type UnwrapResult } from 'abflat';

export async function unwrapAll(meshes: { positions: number[]; indices: Uint8Array }[]): Promise<UnwrapResult[]> {
  const abflat: Abflat = await createAbflat({ maxMemory: 2 ** 30, baseUrl: '/abflat/' });
  const soup = { positions: new Float32Array(9) };
  try {
    await abflat.inspect(soup);
    await abflat.unwrap({ bytes: new Uint8Array(4), name: SAMPLE_NAMES[0] }, { padding: UNWRAP_DEFAULTS.padding });
    const image = { data: new Uint8ClampedArray(4), width: 1, height: 1 };
    const layout = await abflat.unwrap({ positions: [] });
    const baked = await abflat.bake({ positions: [], texcoords: [] }, layout, [{ image, wrapU: 'clamp' }], { kind: 'normal', bakeResolution: 'auto' });
    baked.data.fill(0);
    return await Promise.all(meshes.map((mesh) => abflat.unwrap(mesh, { onProgress: ({ stage }) => void stage })));
  } catch (error) {
    throw error instanceof AbflatError ? new Error(error.code) : error;
  }
}
// @ts-expect-error There is no such option.
export const wrong = (abflat: Abflat) => abflat.unwrap({ positions: [] }, { paddings: 1 });
`;
const SYNC = `
import { createAbflat, type UnwrapResult } from 'abflat';
import { createAbflat as createSimd } from 'abflat/simd';
import { type AbflatSingle, createAbflatSync as createSingle } from 'abflat/single';
import { type AbflatSync, createAbflatSync } from 'abflat/sync';
import { createAbflat as createThreads } from 'abflat/threads';
import { Atlas, createWatlas, Initialize, type MeshDecl } from 'abflat/watlas';

export async function now(bytes: Uint8Array, module: object): Promise<UnwrapResult[]> {
  const abflat: AbflatSync = await createAbflatSync({ wasmUrl: module, packUrl: bytes, also: ['bake'] });
  const mesh = abflat.sample('head');
  const layout: UnwrapResult = abflat.unwrap(mesh, { padding: 4, onProgress: ({ stage }) => void stage });
  await createAbflat({ workers: 2, queue: 4, wasmUrl: bytes });
  await Initialize({ wasmUrl: '/abflat-simd.wasm' });
  const decl: MeshDecl = { vertexCount: 3, vertexPositionData: new Float32Array(9), vertexPositionStride: 12 };
  const atlas: Atlas = new Atlas();
  atlas.addMesh(decl);
  atlas.generate({ maxCost: 2 }, { padding: 4 });
  const [u, v]: [number, number] = atlas.getMesh(0).getVertex(0).uv;
  const { Atlas: Own } = createWatlas(abflat, { maxStretch: 1 + u + v });
  new Own().delete();
  const single: AbflatSingle = createSingle({ maxMemory: 2 ** 30 });
  single.unwrap(mesh);
  for (const create of [createSimd, createThreads]) (await create({ workers: 2 })).terminate();
  return [layout];
}
// @ts-expect-error The result is no promise.
export const wrong = (abflat: AbflatSync) => abflat.unwrap({ positions: [] }).then;
`;
/** Used as they are if they are declared. */
const PLATFORM = `
import { createAbflat } from 'abflat';

export async function timed(controller: AbortController): Promise<void> {
  const abflat = await createAbflat({ baseUrl: new URL('file:///abflat/') });
  await abflat.sample('head', { signal: AbortSignal.timeout(100) });
  await abflat.sample('head', { signal: controller.signal });
}
`;
const GLTF = `
import type { Document, Primitive } from '@gltf-transform/core';
import type { Abflat } from 'abflat';
import { bakeLayout, type DecodeImage, documentMesh, freeTexcoord, pack, sampledTexcoords, setTexcoords, unwrap, verifyDocument } from 'abflat/gltf';

export async function all(abflat: Abflat, document: Document, primitive: Primitive): Promise<number[]> {
  await document.transform(unwrap(abflat, { texcoord: 'auto', onAtlas: ({ texcoord }) => texcoord }));
  await document.transform(unwrap(abflat, { bake: true, onAtlas: ({ baked }) => baked?.map(({ texture, side }) => [texture.getName(), side]) }));
  await document.transform(unwrap(abflat, { preset: 'lightmap', mipLevels: 2, weights: (mesh) => (mesh.getName() ? 2 : undefined) }));
  const decode: DecodeImage = async ({ bytes }) => ({ data: bytes, width: 1, height: bytes.length / 4 });
  await document.transform(pack(abflat, { bake: { decode, encode: (image, map) => ({ bytes: new Uint8Array(image.data), mimeType: map === 'normal' ? 'image/png' : 'image/jpeg' }) } }));
  await document.transform(pack(abflat, { readTexcoord: 1, onAtlas: ({ result }) => result.report.islands }));
  const [verified] = await verifyDocument(abflat, document, { groupBy: 'mesh', padding: 2, maxStretch: 'none' });
  if (verified?.result.report.findings.some(({ rule }) => rule === 'stacked')) throw new Error(verified.parts[0]?.mesh.getName());
  const mesh = documentMesh(document);
  setTexcoords(mesh, await abflat.flatten(mesh), { texcoord: freeTexcoord(document), normalize: true });
  const { baked, notes } = await bakeLayout(abflat, mesh, await abflat.unwrap(mesh), { decode, padding: 4, onProgress: (fraction) => fraction.toFixed() });
  return sampledTexcoords([primitive]).concat(baked.length, notes.length);
}
`;
const THREE = `
import type { Abflat } from 'abflat';
import { packGeometry, toBufferGeometry, type UnwrappedMesh, unwrapGeometry, unwrapScene, verifyGeometry } from 'abflat/three';
import { BoxGeometry, type BufferGeometry, type Mesh, type Object3D } from 'three';

export async function both(abflat: Abflat): Promise<BufferGeometry[]> {
  const { geometry, result } = await unwrapGeometry(abflat, new BoxGeometry(), { attribute: 'uv1' });
  const packed = await packGeometry(abflat, geometry, { readAttribute: 'uv1', islandSizes: 'even' });
  const { report, faults } = await verifyGeometry(abflat, geometry, { attribute: 'uv1', resolution: [64, 32] });
  if (!report.valid) throw new Error(report.findings[0]?.message ?? String(faults.length));
  return [packed.geometry, toBufferGeometry(result, { positions: [] })];
}

export async function scene(abflat: Abflat, object: Object3D, seen: Map<Mesh, number>): Promise<UnwrappedMesh | undefined> {
  const { result, meshes } = await unwrapScene(abflat, object, { preset: 'lightmap', weights: seen, resolution: 2048 });
  return result.report.valid ? meshes.find(({ worldScale, mesh }) => worldScale > 1 && mesh.visible) : undefined;
}
`;

const [BARE, NODE, DOM] = [
  { lib: ['lib.es2022.d.ts'], types: [] },
  { lib: ['lib.es2022.d.ts'], types: ['node'] },
  { lib: ['lib.es2022.d.ts', 'lib.dom.d.ts', 'lib.dom.iterable.d.ts'], types: [] },
];
const NODE16 = {
  module: ts.ModuleKind.Node16,
  moduleResolution: ts.ModuleResolutionKind.Node16,
};
const BUNDLER = {
  module: ts.ModuleKind.ESNext,
  moduleResolution: ts.ModuleResolutionKind.Bundler,
};

let folder;
before(() => {
  mkdirSync(join(ROOT, 'build/tests'), { recursive: true });
  folder = mkdtempSync(join(ROOT, 'build/tests/wasm-types-'));
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
});
after(() => rmSync(folder, { recursive: true }));

/** The compiler's complaints about files with these texts. */
function complaints(texts, options) {
  const files = texts.map((text, i) => {
    const path = join(folder, `case-${i}.ts`);
    writeFileSync(path, text);
    return path;
  });
  const program = ts.createProgram(files, {
    target: ts.ScriptTarget.ES2022,
    strict: true,
    exactOptionalPropertyTypes: true,
    noUncheckedIndexedAccess: true,
    noEmit: true,
    skipLibCheck: false,
    ...options,
  });
  return ts.getPreEmitDiagnostics(program).map(({ file, messageText }) => ({
    file: file?.fileName ?? '',
    text: `${file?.fileName}: ${ts.flattenDiagnosticMessageText(messageText, '\n')}`,
  }));
}

const texts = (found) => found.map(({ text }) => text);
const isOurs = ({ file }) => !file.includes('/node_modules/');

for (const [how, resolution] of Object.entries({ node16: NODE16, bundler: BUNDLER }))
  test(`${how}: arrays and files need ES2022 alone`, () => {
    assert.deepEqual(texts(complaints([ARRAYS, SYNC], { ...BARE, ...resolution })), []);
  });

test('signals and URLs of Node', () => {
  assert.deepEqual(texts(complaints([ARRAYS, PLATFORM], { ...NODE, ...NODE16 })), []);
});

test('those of browsers, glTF-Transform and three.js', () => {
  const found = complaints([ARRAYS, SYNC, PLATFORM, GLTF, THREE], { ...DOM, ...BUNDLER });
  // Declarations of other packages may not suit the compiler.
  assert.deepEqual(texts(found.filter(isOurs)), []);
});
