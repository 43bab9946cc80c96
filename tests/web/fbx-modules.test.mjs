// What becomes of an FBX, without a page.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertValidFile, io } from '../support/gltf.mjs';
import {
  asBinary,
  asText,
  CUBE_QUADS,
  CUBE_VERTICES,
  fbxParts,
  fbxTree,
} from '../support/made-fbx.mjs';
import { loadModule } from './modules.mjs';

const { readFbx } = await loadModule('files/fbx-file');
const { facesOf } = await loadModule('files/fbx-polygons');
const { limitOf } = await loadModule('export/format-limits');
const { node, doubles, floats, ints, longs, properties } = fbxParts;

const TRIANGLES = CUBE_QUADS.flatMap(([a, b, c, d]) => [
  [a, b, c],
  [a, c, d],
]);
const SQUARE = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
];
const UV = CUBE_QUADS.flatMap(() => SQUARE);
const BOX = { name: 'Box', vertices: CUBE_VERTICES, faces: CUBE_QUADS, uv: [UV] };
const PNG = Buffer.from(
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8Dwn4EIwDiqEAAAGgUCARpVpZAAAAAASUVORK5CYII=',
  'base64',
);

const KINDS = { text: (tree) => Buffer.from(asText(tree)), binary: asBinary };
const read = (bytes, name = 'box.fbx', others = []) => readFbx(new File([bytes], name), others);

for (const [kind, write] of Object.entries(KINDS)) {
  test(`${kind}: objects, places, materials, texcoords`, async () => {
    const objects = [
      { ...BOX, material: [0, 1], materialOfFace: [0, 1, 0, 1, 0, 1], translation: [100, 0, 0] },
      { name: 'empty', parent: 0, translation: [0, 0, 20] },
      { ...BOX, name: 'Copy', sameAs: 0, material: [0, 1], parent: 1, scaling: [2, 2, 2] },
    ];
    const materials = [
      { name: 'steel', color: [0.5, 1, 0.25] },
      { name: 'wood', images: [{ file: 'wood.png', content: PNG }] },
    ];
    const { document, lost, remarks } = await read(write(fbxTree({ objects, materials })));
    assert.deepEqual(lost, ['polygons']);
    assert.deepEqual(remarks, [
      'box.fbx is exported as GLB or OBJ, not as FBX.',
      'Its polygons become triangles.',
    ]);
    await assertValidFile(document);
    const root = document.getRoot();
    const places = root.listNodes().map((each) => [each.getName(), each.getWorldTranslation()]);
    // Centimetres become metres.
    assert.deepEqual(
      places.map(([name, at]) => [name, at.map((x) => Number(x.toFixed(6)))]),
      [
        ['box', [0, 0, 0]],
        ['Box', [1, 0, 0]],
        ['empty', [1, 0, 0.2]],
        ['Copy', [1, 0, 0.2]],
      ],
    );
    assert.equal(root.listMeshes().length, 1, 'copies share a mesh');
    const primitives = root.listMeshes()[0].listPrimitives();
    assert.deepEqual(
      primitives.map((each) => each.getMaterial().getName()),
      ['steel', 'wood'],
    );
    for (const [i, each] of primitives.entries()) {
      assert.equal(each.getIndices().getCount(), 18);
      const ends = CUBE_QUADS.flatMap((face, f) =>
        f % 2 === i ? face.map((v, k) => `${v} ${k}`) : [],
      );
      const count = each.getAttribute('POSITION').getCount();
      assert.equal(count, new Set(ends).size, 'corners that agree share a vertex');
      const corners = new Set();
      for (let row = 0; row < count; ++row)
        corners.add(each.getAttribute('TEXCOORD_0').getElement(row, []).join());
      assert.deepEqual([...corners].sort(), ['0,0', '0,1', '1,0', '1,1']);
    }
    const [steel, wood] = primitives.map((each) => each.getMaterial());
    const linear = steel.getBaseColorFactor().map((x) => Number(x.toFixed(3)));
    assert.deepEqual(linear, [0.214, 1, 0.051, 1], 'colours are linear');
    assert.deepEqual(Buffer.from(wood.getBaseColorTexture().getImage()), PNG);
    assert.equal(wood.getBaseColorTexture().getName(), 'wood');
  });

  test(`${kind}: a skin holds its mesh where the file has it, and its animation stays`, async () => {
    const at = (x) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1];
    const extra = ({ models, geometries, add, connect }) => {
      const skin = add('Deformer', 'Skin', 'Skin');
      connect(skin, geometries[0]);
      const halves = [
        [0, 2, 4, 6],
        [1, 3, 5, 7],
      ];
      halves.forEach((indices, i) => {
        const cluster = add('Deformer', `Cluster${i}`, 'Cluster', [
          node('Indexes', [ints(indices)]),
          node('Weights', [doubles(indices.map(() => 1))]),
          node('TransformLink', [doubles(at(50 * i))]),
        ]);
        connect(cluster, skin);
        connect(models[1 + i], cluster);
      });
      const stack = add('AnimationStack', 'Take', '');
      const layer = add('AnimationLayer', 'Base', '');
      const move = add('AnimationCurveNode', 'T', '');
      const curve = add('AnimationCurve', '', '', [
        node('KeyTime', [longs([0, 46186158000])]),
        node('KeyValueFloat', [floats([50, 80])]),
      ]);
      connect(layer, stack);
      connect(move, layer);
      connect(move, models[2], 'Lcl Translation');
      connect(curve, move, 'd|X');
    };
    const objects = [
      { ...BOX, faces: TRIANGLES, uv: [], translation: [0, 30, 0], scaling: [100, 100, 100] },
      { name: 'hip', type: 'LimbNode' },
      { name: 'knee', type: 'LimbNode', parent: 1, translation: [50, 0, 0] },
    ];
    const { document, lost } = await read(write(fbxTree({ objects, extra })));
    assert.deepEqual(lost, []);
    await assertValidFile(document);
    const root = document.getRoot();
    const [skin] = root.listSkins();
    assert.deepEqual(
      skin.listJoints().map((joint) => joint.getName()),
      ['hip', 'knee'],
    );
    // In the pose of the file, joints move nothing.
    const back = skin.getInverseBindMatrices();
    for (const [i, joint] of skin.listJoints().entries())
      assert.deepEqual(product(joint.getWorldMatrix(), back.getElement(i, [])), product());
    const position = root.listMeshes()[0].listPrimitives()[0].getAttribute('POSITION');
    const [min, max] = [position.getMin([]), position.getMax([])];
    assert.deepEqual([min, max].map(rounded), [
      [0, 0.3, 0],
      [1, 1.3, 1],
    ]);
    const [channel] = root.listAnimations()[0].listChannels();
    assert.equal(channel.getTargetNode().getName(), 'knee');
    assert.equal(channel.getTargetPath(), 'translation');
    const sampler = channel.getSampler();
    assert.deepEqual([...sampler.getInput().getArray()], [0, 1]);
    assert.deepEqual([...sampler.getOutput().getArray()], [50, 0, 0, 80, 0, 0]);
  });
}

const rounded = (list) => list.map((x) => Number(x.toFixed(5)) + 0);

/** Of two matrices in columns; the identity without any. */
function product(a = IDENTITY, b = IDENTITY) {
  const out = [];
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      out.push([0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + row] * b[4 * column + k], 0));
  return rounded(out);
}
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

test('morph targets keep their names and what they move', async () => {
  const extra = ({ geometries, add, connect }) => {
    const shape = add('Geometry', 'Wide', 'Shape', [
      node('Indexes', [ints([1, 3])]),
      node('Vertices', [doubles([0.5, 0, 0, 0.25, 0, 0])]),
    ]);
    const channel = add('Deformer', 'Wide', 'BlendShapeChannel', [
      node('FullWeights', [doubles([100])]),
    ]);
    const blend = add('Deformer', 'Blend', 'BlendShape');
    connect(shape, channel);
    connect(channel, blend);
    connect(blend, geometries[0]);
  };
  const { document, lost } = await read(asText(fbxTree({ objects: [BOX], extra })));
  assert.deepEqual(lost, ['polygons']);
  await assertValidFile(document);
  const [mesh] = (await io.readBinary(await io.writeBinary(document))).getRoot().listMeshes();
  assert.deepEqual(mesh.getExtras(), { targetNames: ['Wide'] });
  const [primitive] = mesh.listPrimitives();
  const [base, moved] = [primitive, primitive.listTargets()[0]].map((each) =>
    each.getAttribute('POSITION'),
  );
  for (let i = 0; i < base.getCount(); ++i) {
    const [x, y, z] = base.getElement(i, []);
    const by = x === 1 && z === 0 ? (y === 0 ? 0.5 : 0.25) : 0;
    assert.deepEqual(moved.getElement(i, []), [by, 0, 0]);
  }
});

test('Z may point up, units have any size, and cameras and lights are left out', async () => {
  const extra = ({ models, add, connect }) => {
    for (const [kind, light] of [
      ['Camera', false],
      ['Light', true],
    ]) {
      const attribute = add('NodeAttribute', kind, kind, light ? [node('LightType', [0])] : []);
      const model = add('Model', kind, kind, [properties()]);
      connect(attribute, model);
      connect(model, models[0]);
    }
  };
  const tree = fbxTree({
    objects: [{ ...BOX, faces: TRIANGLES, uv: [] }],
    up: 2,
    unit: 2.54,
    extra,
  });
  const { document, lost, remarks } = await read(asText(tree));
  assert.deepEqual(lost, ['cameras', 'lights']);
  assert.equal(remarks[1], 'Left out: cameras and lights.');
  const box = document
    .getRoot()
    .listNodes()
    .find((each) => each.getName() === 'Box');
  const matrix = box.getWorldMatrix();
  // Three axes of an inch; what pointed along z points along y.
  assert.deepEqual(rounded(matrix.slice(8, 11)), [0, 0.0254, 0]);
});

test('blanks between numbers change nothing', async () => {
  const objects = [{ ...BOX, material: 0, translation: [10, 20, 30] }];
  const text = asText(fbxTree({ objects, materials: [{ name: 'steel', color: [0.5, 1, 0.25] }] }));
  const spread = text.replace(/^\s*P:.*$/gm, (line) => line.replace(/,(?=[-\d])/g, ', '));
  assert.notEqual(spread, text);
  const [before, after] = await Promise.all([read(text), read(spread)]);
  const placesOf = ({ document }) =>
    document
      .getRoot()
      .listNodes()
      .map((each) => each.getWorldMatrix());
  assert.deepEqual(placesOf(after), placesOf(before));
  const colorOf = ({ document }) => document.getRoot().listMaterials()[0].getBaseColorFactor();
  assert.deepEqual(colorOf(after), colorOf(before));
});

test('textures: beside the file, missing, of no use, as opacity', async () => {
  const materials = [
    {
      name: 'leaf',
      images: [
        { file: 'leaf.png' },
        { slot: 'TransparencyFactor', file: 'leaf.png' },
        { slot: 'ShininessExponent', file: 'rough.png' },
        { slot: 'NormalMap', file: 'gone.png' },
      ],
    },
  ];
  const tree = fbxTree({ objects: [{ ...BOX, material: 0 }], materials });
  const others = [new File([PNG], 'textures/LEAF.PNG'), new File([PNG], 'rough.png')];
  const { document, lost, remarks } = await read(asText(tree), 'tree.fbx', others);
  assert.deepEqual(lost, ['maps', 'polygons']);
  assert.deepEqual(remarks.slice(2), [
    'Left out: textures other than colour, normals, occlusion and emission.',
    'Textures not shown: gone.png not found. UVs are unaffected. Drop it together with tree.fbx to see it.',
  ]);
  const [leaf] = document.getRoot().listMaterials();
  assert.equal(leaf.getAlphaMode(), 'BLEND');
  assert.deepEqual(leaf.getBaseColorFactor(), [1, 1, 1, 1]);
  assert.equal(document.getRoot().listTextures().length, 1);
});

test('the menu of exports says what was left out, and what other formats lose besides', () => {
  const gltf = { lost: ['cameras', 'polygons'], holds: ['materials', 'skins'] };
  const outcome = { source: { kind: 'file', name: 'box.fbx' }, gltf };
  assert.equal(limitOf(outcome, 'glb'), 'loses cameras and polygons');
  assert.equal(limitOf(outcome, 'obj'), 'loses polygons, materials and skins');
  assert.equal(limitOf(outcome, 'obj', ['glb', 'obj']), 'loses polygons and skins');
  const glb = { source: { kind: 'file', name: 'box.glb' }, gltf: { ...gltf, lost: [] } };
  assert.equal(limitOf(glb, 'glb'), '');
});

test('polygons are told from triangles', () => {
  for (const [faces, expected] of [
    [CUBE_QUADS, true],
    [TRIANGLES, false],
    [[...TRIANGLES, [0, 2, 3, 1]], true],
    [Array(60).fill(TRIANGLES[0]), false],
    [Array(60).fill(CUBE_QUADS[0]), true],
  ]) {
    const tree = fbxTree({ objects: [{ ...BOX, faces, uv: [] }] });
    const told = { hasPolygons: expected, areWhole: true };
    assert.deepEqual(facesOf(Buffer.from(asText(tree)), false), told);
    assert.deepEqual(facesOf(new Uint8Array(asBinary(tree)), true), told);
  }
});

test('what cannot be read gets a sentence', async () => {
  const good = fbxTree({ objects: [BOX] });
  const old = fbxTree({ objects: [BOX], version: 6100 });
  const cut = asBinary(good).subarray(0, 700);
  const outside = (text) => text.replace('0,2,3,-2', '0,2,99,-2');
  for (const [bytes, expected] of [
    ['', /^box\.fbx is empty\./],
    ['hello', /^box\.fbx is not an FBX file, because it does not begin like one\./],
    ['Kaydara FBX Binary', /^box\.fbx is not an FBX file/],
    [asText(old), /^box\.fbx is FBX 6\.1, which is too old to read\. Save it as FBX 7\.4/],
    [asBinary(old), /^box\.fbx is FBX 6\.1, which is too old to read/],
    [cut, /^box\.fbx is damaged, or holds what this page cannot read \(.*\)\. Export it again/],
    [asText(good).slice(0, 900), /^box\.fbx is damaged, or holds/],
    [outside(asText(good)), /^box\.fbx is damaged.* \(a face has a vertex that is not there\)/],
  ])
    await assert.rejects(read(bytes), { message: expected });
});
