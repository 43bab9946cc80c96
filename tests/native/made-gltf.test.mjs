// glTF made from other formats contains what they say about a mesh's look.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { randomNumbers } from '../support/disks.mjs';
import { elementsOf, parseGltf } from '../support/glb.mjs';
import { errorsIn } from '../support/gltf-errors.mjs';
import { drum, forCorners, PNG, partsOf } from '../support/made-gltf.mjs';
import { PLY_FORMATS, plyBytes } from '../support/ply.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { objText, torus } from '../support/surfaces.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

async function converted(at, input, output, ...options) {
  const args = ['unwrap', input, '-o', output, '--report', 'r.json', ...options];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  assert.deepEqual(await errorsIn(at(output), at), []);
  return {
    model: parseGltf(readFileSync(at(output))),
    notes: JSON.parse(readFileSync(at('r.json'))).notes,
  };
}

const unit = (p) => p.map((x) => x / Math.hypot(...p));
const near = (a, b, most = 1e-6) =>
  assert.ok(
    a.every((x, d) => Math.abs(x - b[d]) <= most),
    `${a} is not ${b}`,
  );
const linear = (x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);

const OBJECTS = ['left drum', 'right'];
const MATERIALS = ['wood #2', 'metal'];

/**
 * A drum as OBJ text, and its faces as written: { object, material, corners: [{ position, color,
 * uv, normal }] }.
 */
function richObj({ seed = 1 } = {}) {
  const random = randomNumbers(seed);
  const { positions, faces } = drum(7, 4, seed);
  const colors = positions.map(() => [random(), random(), random()]);
  const lines = ['mtllib the materials.mtl'];
  lines.push(...positions.map((p, v) => `v ${[...p, ...colors[v]].join(' ')}`));
  const written = faces.map((face, f) => {
    const object = OBJECTS[f < faces.length / 2 ? 0 : 1];
    const material = MATERIALS[Math.floor(random() * 2)];
    const corners = face.map((v) => {
      const uv = [random(), random()].map(Math.fround);
      const normal = [random() - 0.5, random() - 0.5, random() + 0.1].map((x) => 3 * x);
      lines.push(`vt ${uv.join(' ')}`, `vn ${normal.join(' ')}`);
      return { position: positions[v], color: colors[v], uv, normal, v };
    });
    const words = corners.map(({ v }, k) => {
      const back = k - face.length;
      return `${v + 1}/${back}/${back}`;
    });
    lines.push(`o ${object}`, `usemtl ${material}`, `f ${words.join(' ')}`);
    return { object, material, corners };
  });
  return { text: `${lines.join('\n')}\n`, faces: written };
}

const MTL = `newmtl wood #2\r\nKd 0 0 0\r\nmap_Kd -s 1 1 1 -clamp on maps\\\\oak 1.png\r\n
newmtl metal\nKd 0.5 0.25 1\nKe 1 0 0\nd 0.75\nTr 0.9\nPm 1\nPr 0.5\nnewmtl metal\nKd 0 0 0\n`;

function writeRich(at, folder) {
  const obj = richObj();
  mkdirSync(at(`${folder}/maps`), { recursive: true });
  writeFileSync(at(`${folder}/in.obj`), obj.text);
  writeFileSync(at(`${folder}/the materials.mtl`), MTL);
  writeFileSync(at(`${folder}/maps/oak 1.png`), PNG);
  return obj;
}

/** Calls `check(corner, corner of the OBJ)` for all corners of all parts. */
function assertParts(model, faces, check) {
  const parts = partsOf(model);
  assert.equal(
    new Set(parts.map(({ name, material }) => `${name}/${material.name}`)).size,
    parts.length,
  );
  let total = 0;
  for (const { name, material, triangles } of parts) {
    const own = faces.filter((f) => f.object === name && f.material === material.name);
    assert.equal(
      forCorners(
        triangles,
        own.map(({ corners }) => corners),
        check,
      ),
      0,
    );
    total += own.length;
  }
  assert.equal(total, faces.length);
}

for (const ending of ['glb', 'gltf'])
  test(`an OBJ keeps normals, colours, objects and materials, .${ending}`, async (t) => {
    const at = tempFolder(t);
    const { faces } = writeRich(at, 'model');
    const { model, notes } = await converted(at, 'model/in.obj', `out.${ending}`);
    assert.deepEqual(
      notes.filter((n) => /image|material/.test(n)),
      [],
    );
    assertParts(model, faces, (corner, { normal, color, uv }) => {
      near(corner.NORMAL, unit(normal));
      near(
        corner.COLOR_0.map((x) => x / 65535),
        [...color.map(linear), 1],
        1e-5,
      );
      if (corner.TEXCOORD_1) near(corner.TEXCOORD_1, [uv[0], 1 - uv[1]], 1e-7);
    });
    const { json, buffer } = model;
    assert.deepEqual(
      json.nodes.map(({ name, mesh }) => [name, mesh]),
      OBJECTS.map((name, i) => [name, i]),
    );
    const [wood, metal] = MATERIALS.map((name) => json.materials.find((m) => m.name === name));
    const { baseColorTexture, baseColorFactor } = wood.pbrMetallicRoughness;
    assert.deepEqual([baseColorFactor, baseColorTexture], [undefined, { index: 0, texCoord: 1 }]);
    const { bufferView, mimeType } = json.images[json.textures[0].source];
    const { byteOffset, byteLength } = json.bufferViews[bufferView];
    assert.equal(mimeType, 'image/png');
    assert.deepEqual(buffer.subarray(byteOffset, byteOffset + byteLength), PNG);
    for (const { material, triangles } of partsOf(model))
      assert.equal(triangles[0][0].TEXCOORD_1 !== undefined, material === wood);
    const look = metal.pbrMetallicRoughness;
    near(look.baseColorFactor, [...[0.5, 0.25, 1].map(linear), 0.75]);
    assert.deepEqual([look.metallicFactor, look.roughnessFactor], [1, 0.5]);
    assert.deepEqual([metal.emissiveFactor, metal.alphaMode], [[1, 0, 0], 'BLEND']);
  });

test('a lightmap set leaves the texcoords and the images of an OBJ where they are', async (t) => {
  const at = tempFolder(t);
  const { faces } = writeRich(at, 'model');
  const { model } = await converted(at, 'model/in.obj', 'out.glb', '--texcoord', '2');
  assertParts(model, faces, ({ TEXCOORD_0, TEXCOORD_1, TEXCOORD_2 }, { uv }) => {
    near(TEXCOORD_0, [uv[0], 1 - uv[1]], 1e-7);
    assert.deepEqual(TEXCOORD_1, TEXCOORD_2);
  });
  const textured = model.json.materials.find((m) => m.name === MATERIALS[0]);
  assert.deepEqual(textured.pbrMetallicRoughness.baseColorTexture, { index: 0 });
});

test('what an OBJ names but does not have is told, and is no error', async (t) => {
  const at = tempFolder(t);
  const { faces } = writeRich(at, 'model');
  writeFileSync(at('in.obj'), readFileSync(at('model/in.obj')));
  const alone = await converted(at, 'in.obj', 'out.glb');
  assert.match(
    alone.notes.join('\n'),
    /^the materials in the materials\.mtl keep only their names: cannot read the materials\.mtl: .*$/,
  );
  assertParts(alone.model, faces, ({ TEXCOORD_1 }) => assert.equal(TEXCOORD_1, undefined));
  writeFileSync(at('the materials.mtl'), MTL);
  const bare = await converted(at, 'in.obj', 'out.glb');
  assert.ok(
    bare.notes.some((n) => /image maps\/+oak 1\.png was left out: cannot read/.test(n)),
    `${bare.notes}`,
  );
  assert.equal(bare.model.json.images, undefined);
  writeFileSync(at('oak 1.png'), 'no picture');
  const wrong = await converted(at, 'in.obj', 'out.glb');
  assert.ok(
    wrong.notes.some((n) => /oak 1\.png was left out: glTF supports only PNG and JPEG/.test(n)),
  );
  writeFileSync(at('oak 1.png'), PNG);
  assert.equal((await converted(at, 'in.obj', 'out.glb')).model.json.images.length, 1);
});

test('corners without a normal get that of their face, others of the vertex keep theirs', async (t) => {
  const at = tempFolder(t);
  const ring = torus(12, 6);
  let f = 0;
  const text = objText(ring, 'vn 0 0 0\nvn 0 0 9e200\nvn x 1 1\n').replaceAll(/^f .*/gm, (line) => {
    const normal = ['', '//1', '//2', '//3', '//99', '//-2'][f++ % 6];
    return line.replaceAll(/ (\d+)/g, ` $1${normal}`);
  });
  writeFileSync(at('in.obj'), text);
  const { model } = await converted(at, 'in.obj', 'out.glb');
  const [{ triangles }] = partsOf(model);
  assert.equal(triangles.length, ring.faces.length);
  for (const [i, triangle] of triangles.entries()) {
    const [a, b, c] = triangle.map(({ POSITION }) => POSITION);
    const [p, q] = [b.map((x, d) => x - a[d]), c.map((x, d) => x - a[d])];
    const own = unit(
      [0, 1, 2].map((d) => p[(d + 1) % 3] * q[(d + 2) % 3] - p[(d + 2) % 3] * q[(d + 1) % 3]),
    );
    const hasOne = i % 6 === 2 || i % 6 === 5;
    for (const { NORMAL } of triangle) near(NORMAL, hasOne ? [0, 0, 1] : own, 1e-5);
  }
});

for (const format of PLY_FORMATS)
  for (const type of ['uchar', 'float'])
    test(`a PLY keeps normals, colours and its image, ${format}, ${type}`, async (t) => {
      const at = tempFolder(t);
      const random = randomNumbers(3);
      const { positions, faces } = drum();
      const most = type === 'uchar' ? 255 : 1;
      const color = () => (type === 'uchar' ? Math.floor(256 * random()) : Math.fround(random()));
      const vertices = positions.map((position) => ({
        position,
        normal: [random() - 0.5, 1 + random(), random()].map(Math.fround),
        color: [color(), color(), color(), color()],
        uv: [random(), random()].map(Math.fround),
      }));
      const named = (kind, ...names) => names.map((name) => ({ name, type: kind }));
      const file = {
        format,
        comments: ['TextureFile a b.png'],
        elements: [
          {
            name: 'before',
            properties: [...named('int', 'a'), { name: 'l', type: 'uchar', countType: 'uchar' }],
            rows: [
              [1, [2, 3]],
              [4, []],
            ],
          },
          {
            name: 'vertex',
            properties: [
              ...named(type, 'red'),
              ...named('float', 'nx', 'x', 'y', 'z', 'ny', 'nz', 's', 't'),
              { name: 'list', type: 'short', countType: 'uchar' },
              ...named(type, 'alpha', 'blue', 'green'),
            ],
            rows: vertices.map(({ position: p, normal: n, color: c, uv }, v) => [
              c[0],
              n[0],
              ...p,
              n[1],
              n[2],
              ...uv,
              Array(v % 3).fill(v),
              c[3],
              c[2],
              c[1],
            ]),
          },
          {
            name: 'face',
            properties: [{ name: 'vertex_indices', type: 'int', countType: 'uchar' }],
            rows: faces.map((face) => [face]),
          },
        ],
      };
      writeFileSync(at('in.ply'), plyBytes(file));
      writeFileSync(at('a b.png'), PNG);
      const { model } = await converted(at, 'in.ply', 'out.glb');
      const [{ triangles, material }] = partsOf(model);
      assert.equal(material.pbrMetallicRoughness.baseColorTexture.texCoord, 1);
      const corners = faces.map((face) => face.map((v) => vertices[v]));
      const rest = forCorners(triangles, corners, (corner, { normal, color: [r, g, b, a], uv }) => {
        near(corner.NORMAL, unit(normal));
        near(
          corner.COLOR_0.map((x) => x / 65535),
          [...[r, g, b].map((x) => linear(x / most)), a / most],
          1e-5,
        );
        near(corner.TEXCOORD_1, [uv[0], 1 - uv[1]], 1e-7);
      });
      assert.equal(rest, 0);
    });

test('without anything to say a glTF has positions and texcoords alone', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('in.obj'), objText(torus(12, 6)));
  const { model } = await converted(at, 'in.obj', 'out.glb');
  const [{ attributes }] = model.json.meshes[0].primitives;
  assert.deepEqual(Object.keys(attributes), ['POSITION', 'TEXCOORD_0']);
});

/** A wavy sheet of 20 x 20 units, away from the origin. */
function survey(offset) {
  const n = 30;
  const positions = Array.from({ length: (n + 1) ** 2 }, (_, k) => {
    const [x, y] = [k % (n + 1), Math.floor(k / (n + 1))].map((i) => (20 * i) / n);
    return [x, y, Math.sin(x) * Math.cos(y)].map((a, d) => a + offset[d]);
  });
  const faces = Array.from({ length: n * n }, (_, k) => {
    const a = (k % n) + Math.floor(k / n) * (n + 1);
    return [a, a + 1, a + n + 2, a + n + 1];
  });
  return { positions, faces };
}

/** The largest distance of a vertex in the scene from where the OBJ has it, and the translation. */
function displacement({ json, buffer }, { positions, faces }) {
  const model = { json, buffer };
  const [{ translation = [0, 0, 0], mesh }] = json.nodes;
  const [{ attributes }] = json.meshes[mesh].primitives;
  const own = elementsOf(model, attributes.POSITION);
  // Vertices are numbered by first use, and repeated where their texcoords differ.
  const known = new Map(positions.map((p, v) => [`${p.map((x) => Math.round(4 * x))}`, v]));
  assert.equal(known.size, positions.length);
  let most = 0;
  for (const p of own) {
    const place = p.map((x, d) => x + translation[d]);
    const v = known.get(`${place.map((x) => Math.round(4 * x))}`);
    assert.notEqual(v, undefined, `${place}`);
    most = Math.max(most, ...place.map((x, d) => Math.abs(x - positions[v][d])));
  }
  assert.ok(own.length >= new Set(faces.flat()).size);
  return { most, translation };
}

test('a mesh far from the origin keeps its shape: nodes carry the distance', async (t) => {
  const at = tempFolder(t);
  for (const offset of [
    [512345.25, 5412345.75, 230],
    [-7e8, 12, 1e6],
  ]) {
    const mesh = survey(offset.map((x) => x + 0.0625));
    writeFileSync(at('in.obj'), objText(mesh));
    for (const output of ['out.glb', 'out.gltf']) {
      const args = ['unwrap', 'in.obj', '-o', output, '--report', 'r.json'];
      const { code, stderr } = await runAbflat(args, { cwd: at() });
      assert.equal(code, 0);
      assert.match(
        stderr,
        /^abflat: in\.obj: the mesh is far from the origin, where single precision/,
      );
      assert.deepEqual(await errorsIn(at(output), at), []);
      const model = parseGltf(readFileSync(at(output)));
      const { most, translation } = displacement(model, mesh);
      assert.ok(most < 1e-5, `${most}`);
      assert.deepEqual(translation, translation.map(Math.fround));
      const { notes } = JSON.parse(readFileSync(at('r.json')));
      assert.ok(
        notes.some((note) => note.includes(`translated by (${translation.join(', ')})`)),
        `${notes}`,
      );
      // The program itself reads the mesh where it was.
      const again = await runAbflat(['unwrap', output, '-o', 'again.obj', '-q'], { cwd: at() });
      assert.deepEqual([again.code, again.stderr], [0, '']);
      const places = new Set(mesh.positions.map((p) => `${p.map((x) => Math.round(4 * x))}`));
      for (const [, words] of readFileSync(at('again.obj'), 'utf8').matchAll(/^v (.*)/gm))
        assert.ok(places.has(`${words.split(' ').map((x) => Math.round(4 * Number(x)))}`));
    }
  }
});

test('a mesh whose rounding shows nowhere is not moved', async (t) => {
  const at = tempFolder(t);
  // The last is far away, but its coordinates are exact in single precision.
  for (const mesh of [
    survey([0, 0, 0]),
    survey([15, -30, 1000]),
    {
      positions: survey([0, 0, 0]).positions.map((p) => p.map((x) => 5e6 + Math.round(8 * x))),
      faces: survey([0, 0, 0]).faces,
    },
  ]) {
    writeFileSync(at('in.obj'), objText(mesh));
    const { model, notes } = await converted(at, 'in.obj', 'out.glb');
    assert.deepEqual(Object.keys(model.json.nodes[0]), ['mesh']);
    assert.deepEqual(
      notes.filter((note) => /precision/.test(note)),
      [],
    );
  }
});

test('what an offset cannot help is told', async (t) => {
  const at = tempFolder(t);
  // As wide as it is far from the origin, and fine where it is furthest.
  const columns = Array.from({ length: 25 }, (_, i) => 1e6 + 0.3 - 10 ** (i / 4));
  const positions = columns.flatMap((x) => [0, 1, 2].map((row) => [x, 500 * row, 0]));
  const faces = columns.slice(1).flatMap((_, i) =>
    [0, 1].map((row) => {
      const a = 3 * i + row;
      return [a, a + 1, a + 4, a + 3];
    }),
  );
  writeFileSync(at('in.obj'), objText({ positions, faces }));
  const args = ['unwrap', 'in.obj', '-o', 'out.glb', '--report', 'r.json', '-q'];
  const { code, stderr } = await runAbflat(args, { cwd: at() });
  assert.deepEqual([code, stderr], [0, '']);
  assert.match(
    JSON.parse(readFileSync(at('r.json'))).notes.join('\n'),
    /^single precision, all that glTF has, moves vertices by up to 0\.0[23]\d?\. Write OBJ or PLY/m,
  );
});
