// How a file looks, besides its shape: corners, materials of OBJ, colours of PLY, sentences.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { KHRTextureTransform } from '@gltf-transform/extensions';
import { createAbflat } from 'abflat';
import { accessor, io } from '../support/gltf.mjs';
import { oneColor, paintedDocument, RED, textured } from '../support/painted.mjs';
import { loadModule as load } from './modules.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

/**
 * Vertex 2 has two quads around it. With a face that repeats it, layouts cut the first one into other
 * triangles than the mesh.
 */
const POLYGONS = `v 0 0 0\nv 1 -0.5 0\nv 2 0 0\nv 1 2 0\nv 1 -2 0\nv 0 3 0\nv -1 2 0
vt 0.1 0\nvt 0.2 0\nvt 0.3 0\nvt 0.4 0\nvt 0.5 0
f 1/1 2/2 3/3 4/4
f 3/3 2/2 1/1 5/5
f 1/1 4/4 6/5 7/2
f 2/2 2/2 1/1
`;

const fileOf = (text, name) => ({ bytes: new TextEncoder().encode(text), name });

test('every corner of a mesh, and of its layout, leads to the corner of the file', async () => {
  const { sourceCorners, meshCorners } = await load('mesh/source-corners');
  const { readObjCorners } = await load('files/obj-corners');
  const mesh = await abflat.load(fileOf(POLYGONS, 'polygons.obj'));
  const obj = readObjCorners(POLYGONS);
  const source = sourceCorners(mesh, obj);
  mesh.indices.forEach((vertex, c) => {
    const face = mesh.faces[Math.floor(c / 3)];
    assert.equal(obj.vertices[source[c]], vertex);
    assert.ok(source[c] >= obj.offsets[face] && source[c] < obj.offsets[face + 1]);
  });
  const layout = await abflat.unwrap(fileOf(POLYGONS, 'polygons.obj'));
  const corners = meshCorners(mesh, layout);
  assert.ok(corners, 'some differ');
  layout.indices.forEach((v, c) => {
    const same = corners[c] - 1;
    assert.equal(mesh.indices[same], layout.vertexMap[v]);
    assert.equal(mesh.faces[Math.floor(same / 3)], mesh.faces[Math.floor(c / 3)]);
  });
  assert.equal(
    meshCorners(mesh, { indices: mesh.indices, vertexMap: [...Array(7).keys()] }),
    undefined,
  );
});

test('a corner that its face lacks has no source', async () => {
  const { NO_CORNER, sourceCorners } = await load('mesh/source-corners');
  const file = { offsets: [0, 3], vertices: [4, 5, 6] };
  const corners = sourceCorners({ indices: Uint32Array.of(4, 6, 7) }, file);
  assert.deepEqual([...corners], [0, 2, NO_CORNER]);
});

test('an OBJ has materials, texcoords of corners and colours of vertices', async () => {
  const { readObjCorners, NO_TEXCOORD } = await load('files/obj-corners');
  const read = readObjCorners(
    [
      'mtllib a b.mtl',
      'v 0 0 0 1 0 0.5',
      'v 1 0 0 # no colour',
      'v 0 1 0 1 1 1',
      'v 0 0 1',
      'vt 0.25 0.5',
      'vt 1',
      'f 1/1 2/2 3',
      'usemtl red wood',
      'f -4//1 \\',
      '  -3/-1 -1/9',
      'usemtl',
      'f 1 2 4',
      'usemtl red wood',
      'f 1 2 4',
    ].join('\r\n'),
  );
  assert.deepEqual(read.libraries, ['a b.mtl']);
  assert.deepEqual(read.names, ['', 'red wood']);
  assert.deepEqual(read.materials, [0, 1, 0, 1]);
  assert.deepEqual(read.offsets, [0, 3, 6, 9, 12]);
  assert.deepEqual(read.vertices.slice(0, 6), [0, 1, 2, 0, 1, 3]);
  assert.deepEqual(read.texcoordOf.slice(0, 6), [0, 1, NO_TEXCOORD, NO_TEXCOORD, 1, 8]);
  assert.deepEqual(read.texcoords, [0.25, 0.5, 1, 0]);
  const { NaN: none } = Number;
  assert.deepEqual(read.colors, [1, 0, 0.5, none, none, none, 1, 1, 1, none, none, none]);
  assert.equal(readObjCorners(POLYGONS).colors, null);
});

test('an MTL gives each material its colour, opacity and image', async () => {
  const { readMtl } = await load('files/mtl');
  const found = readMtl(
    `newmtl wood
     Kd 0.5 0.25 1
     map_Kd -s 2 3 1 -o 0.5 -clamp on old wood.png
     Tr 0.25
     newmtl leaf
     Tr 0.9
     d 0.5
     map_Kd leaf.png
     map_d leaf.png
     newmtl grey
     Kd 0.5
     newmtl wood
     Kd 0 0 0`,
  );
  const wood = found.get('wood');
  assert.deepEqual(wood.diffuse, [0.5, 0.25, 1]);
  assert.equal(wood.map, 'old wood.png');
  assert.deepEqual([wood.scale, wood.offset, wood.isClamped], [[2, 3], [0.5, 0], true]);
  assert.equal(wood.opacity, 0.75);
  assert.ok(!wood.hasAlpha);
  const leaf = found.get('leaf');
  assert.equal(leaf.opacity, 0.5);
  assert.ok(leaf.hasAlpha);
  assert.deepEqual(found.get('grey').diffuse, [0.5, 0.5, 0.5]);
});

test('a PLY has colours in any encoding, and none where vertices have lists', async () => {
  const { plyVertexNumbers } = await load('files/ply-vertices');
  const header = (format, type) =>
    `ply\nformat ${format} 1.0\ncomment made here\nelement vertex 2\nproperty float x\nproperty ${type} red\nproperty ${type} green\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n`;
  const names = ['green', 'red'];
  const encode = (text) => new TextEncoder().encode(text);
  const plain = plyVertexNumbers(encode(`${header('ascii', 'uchar')}0 1 2\n5 255 4\n`), names);
  assert.deepEqual(plain, { values: Float64Array.of(2, 1, 4, 255), largest: 255 });
  for (const isLittle of [true, false]) {
    const format = `binary_${isLittle ? 'little' : 'big'}_endian`;
    const body = new DataView(new ArrayBuffer(16));
    [1, 2, 255, 4].forEach((value, i) => {
      body.setUint16([4, 6, 12, 14][i], value, isLittle);
    });
    const bytes = Buffer.concat([encode(header(format, 'ushort')), new Uint8Array(body.buffer)]);
    const found = plyVertexNumbers(new Uint8Array(bytes), names);
    assert.deepEqual(found, { values: Float64Array.of(2, 1, 4, 255), largest: 65535 });
  }
  assert.equal(plyVertexNumbers(encode(header('ascii', 'uchar')), ['blue']), null);
  const lists = header('ascii', 'list uchar uchar');
  assert.equal(plyVertexNumbers(encode(lists), names), null);
  assert.equal(plyVertexNumbers(encode('no mesh'), names), null);
});

test('a glTF says where corners lie in its images, and how they are tinted', async () => {
  const { readGltfLook } = await load('files/gltf-look');
  const document = paintedDocument((document, material, primitive) => {
    textured('red', oneColor(RED))(document, material);
    const transform = document.createExtension(KHRTextureTransform).createTransform();
    transform
      .setScale([2, 4])
      .setRotation(Math.PI / 2)
      .setOffset([10, 20])
      .setTexCoord(1);
    material
      .setBaseColorFactor([0.5, 1, 1, 0.25])
      .setAlphaMode('MASK')
      .getBaseColorTextureInfo()
      .setWrapS(33071)
      .setWrapT(33648)
      .setMagFilter(9728)
      .setExtension('KHR_texture_transform', transform);
    const count = primitive.getAttribute('POSITION').getCount();
    const uv = new Float32Array(2 * count).fill(1);
    primitive.setAttribute('TEXCOORD_1', accessor(document, 'VEC2', uv));
    const colors = new Uint8Array(4 * count).fill(255);
    primitive.setAttribute('COLOR_0', accessor(document, 'VEC4', colors, true));
  });
  const bytes = await io.writeBinary(document);
  const { corners, materials, images } = await readGltfLook({
    file: new File([bytes], 'a.glb'),
    others: [],
  });
  assert.deepEqual(materials, [
    { image: 0, wrap: [2, 1], isPixelated: true, cutoff: 0.5, isUnlit: false },
  ]);
  assert.equal(images[0].name, 'red');
  const floats = new Float32Array(corners.words.buffer);
  // Scaled to (2, 4), turned to (4, -2), moved.
  assert.ok(Math.abs(floats[0] - 14) < 1e-6 && Math.abs(floats[1] - 18) < 1e-6);
  const tint = new Uint8Array(corners.words.buffer).subarray(12, 16);
  // Half of the light is 188 in sRGB.
  assert.deepEqual([...tint], [188, 255, 255, 64]);
  assert.equal(corners.onlyTint, corners.words[3]);
});

test('what reads materials is loaded only for files that may have some', async () => {
  const { hasLook } = await load('files/has-look');
  const has = (name, content) => hasLook(new File([content], name));
  assert.ok(await has('a.obj', 'v 0 0 0\nusemtl wood\nf 1 1 1'));
  assert.ok(await has('a.OBJ', 'v 0 0 0\nv 0 1 -1.5e2 0.1 .5 1\r\nf 1 1 1'));
  assert.ok(!(await has('a.obj', 'v 0 0 0\nvn 1 2 3 4 5 6\nf 1 1 1')));
  assert.ok(await has('a.ply', 'ply\nelement vertex 1\nproperty uchar red\n'));
  assert.ok(!(await has('a.ply', 'ply\nelement vertex 1\nproperty float x\n')));
  assert.ok(!(await has('a.stl', 'usemtl')));
  for (const paint of [textured('red', oneColor(RED)), () => undefined]) {
    const bytes = await io.writeBinary(paintedDocument(paint));
    const file = new File([bytes], 'a.glb');
    const isPainted = await hasLook(file, { file, others: [] });
    assert.equal(isPainted, paint.length > 0);
  }
});

test('colours of vertices are found where a file begins', async () => {
  const { hasColors } = await load('files/has-look');
  const has = (name, content) => hasColors(new File([content], name));
  assert.ok(await has('a.obj', '# made here\nv 0 0 0 1 0 0\nf 1 1 1'));
  assert.ok(!(await has('a.obj', 'v 0 0 0\nusemtl wood\nf 1 1 1')));
  assert.ok(await has('a.PLY', 'ply\nelement vertex 1\nproperty float diffuse_red\n'));
  assert.ok(!(await has('a.ply', 'ply\nelement vertex 1\nproperty float x\n')));
  assert.ok(!(await has('a.off', 'v 0 0 0 1 0 0')));
});

test('images share their memory', async () => {
  const { sideFor } = await load('files/look-images');
  assert.equal(sideFor(1, 2 ** 27), 2048);
  assert.equal(sideFor(8, 2 ** 27), 2048);
  assert.equal(sideFor(20, 2 ** 27), 1024);
  assert.equal(sideFor(2, 2 ** 25), 2048);
  assert.equal(sideFor(1000, 2 ** 25), 64);
});

test('missing files are listed in a sentence', async () => {
  const { listed } = await load('words/format');
  const { fileNamed, remarksOn } = await load('files/missing-files');
  assert.equal(listed(['a', 'b', 'c', 'd']), 'a, b, c and d');
  assert.equal(listed(['a', 'b', 'c', 'd', 'e']), 'a, b, c and 2 more');
  assert.deepEqual(remarksOn('m.obj', ['a.png', 'b.png', 'a.png'], ['c.tga']), [
    'Textures not shown: a.png and b.png not found. UVs are unaffected. Drop them together with m.obj to see them.',
    'This browser cannot decode c.tga: save it as PNG or JPEG.',
  ]);
  assert.deepEqual(remarksOn('m.obj', [], []), []);
  const file = { name: 'Wood.PNG' };
  assert.equal(fileNamed('C:\\textures\\wood.png', [{ name: 'x' }, file]), file);
  assert.equal(fileNamed('maps/stone.png', [file]), undefined);
});
