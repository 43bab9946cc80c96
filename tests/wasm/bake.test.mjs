// Old textures in a new layout: what bake makes of pixels.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import {
  imageOf,
  mostDifference,
  oneColour,
  pixelOf,
  SQUARE,
  turnedUv,
  waves,
} from './support/bake.mjs';

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

test('a layout that stays has the pixels it had, whatever they stand for', async () => {
  const image = imageOf(256, 256, (x, y) => [x, y, (x * y) % 256, 255 - (x >> 1)]);
  for (const kind of ['colour', 'data']) {
    const made = await abflat.bake(SQUARE, { uv: SQUARE.texcoords }, { image }, { kind });
    assert.deepEqual([made.width, made.height], [256, 256]);
    assert.ok(mostDifference(made.data, image.data) <= 1, kind);
  }
});

test('a tilted normal map stays one', async () => {
  const image = imageOf(64, 64, () => [178, 128, 245]);
  const options = { kind: 'normal', bakeResolution: 64 };
  const { data } = await abflat.bake(SQUARE, { uv: SQUARE.texcoords }, { image }, options);
  assert.ok(mostDifference(data, image.data) <= 1);
});

test('a result of unwrap or pack is a layout as it is', async () => {
  const mesh = await abflat.sample('head');
  const texcoords = mesh.positions.slice(0, (2 * mesh.positions.length) / 3);
  for (let v = 0; v < texcoords.length / 2; ++v)
    texcoords.set([mesh.positions[3 * v] / 4, mesh.positions[3 * v + 1] / 4], 2 * v);
  const old = { ...mesh, texcoords };
  const image = waves(512);
  const colourAt = (u, v) =>
    [0, 1, 2].map(
      (d) => 128 + 100 * Math.sin(4 * Math.PI * u + 2 * d) * Math.cos(2 * Math.PI * v + d),
    );
  for (const layout of [await abflat.unwrap(old), await abflat.pack(old)]) {
    const made = await abflat.bake(old, layout, { image }, { bakeResolution: 1024 });
    let sum = 0;
    const triangles = layout.indices.length / 3;
    for (let t = 0; t < triangles; ++t) {
      const corners = [...layout.indices.subarray(3 * t, 3 * t + 3)];
      const middle = (list, of) => corners.reduce((at, c) => at + list[of(c)] / 3, 0);
      const [u, v] = [0, 1].map((d) => middle(layout.uv, (c) => 2 * c + d));
      const [s, r] = [0, 1].map((d) => middle(texcoords, (c) => 2 * layout.vertexMap[c] + d));
      // Texel 0 of the waves has the value of its corner.
      const expected = colourAt(s - 0.5 / 512, 1 - r - 0.5 / 512);
      const found = pixelOf(made, Math.floor(1024 * u), Math.floor(1024 * (1 - v)));
      sum += mostDifference(found.slice(0, 3), expected);
    }
    assert.ok(sum / triangles < 4, `${sum / triangles} of 255`);
  }
});

test('a plane that is turned by 37 degrees keeps its lighting', async () => {
  const degrees = 37;
  const image = imageOf(64, 64, (x, y) => {
    const [a, b] = [0.6 * Math.sin(x / 7), 0.5 * Math.cos(y / 9)];
    const length = Math.hypot(a, b, 1);
    return [a, b, 1].map((n) => Math.round(127.5 + (127.5 * n) / length));
  });
  const uv = turnedUv(SQUARE.texcoords, degrees, 0.6);
  const options = { kind: 'normal', bakeResolution: 256 };
  const made = await abflat.bake(SQUARE, { uv }, { image }, options);
  const normalAt = ({ data, width, height }, u, v) => {
    const at = 4 * (Math.floor((1 - v) * height) * width + Math.floor(u * width));
    const n = [...data.subarray(at, at + 3)].map((x) => x / 127.5 - 1);
    return n.map((x) => x / Math.hypot(...n));
  };
  // Seen in the plane, where the tangent of the old layout is x and that of the new one is turned.
  const light = [0.3, -0.5, 0.8].map((x) => x / Math.hypot(0.3, -0.5, 0.8));
  const [c, s] = [Math.cos, Math.sin].map((of) => of((degrees * Math.PI) / 180));
  let most = 0;
  for (let y = 4.5; y < 60; ++y)
    for (let x = 4.5; x < 60; ++x) {
      const at = [x / 64, y / 64];
      const old = normalAt(image, ...at);
      const [a, b, n] = normalAt(made, ...turnedUv(at, degrees, 0.6));
      const now = [c * a + s * b, -s * a + c * b, n];
      const shade = (normal) => normal.reduce((sum, value, d) => sum + value * light[d], 0);
      most = Math.max(most, Math.abs(shade(now) - shade(old)));
    }
  assert.ok(most < 0.06, `${most}`);
});

test('sources have the triangles of their material, wraps, transforms and factors', async () => {
  const mesh = { ...SQUARE, texcoords: SQUARE.texcoords.map((x) => 2 * x), materials: [0, 1] };
  const halves = imageOf(64, 64, (x) => (x < 32 ? [255, 0, 0] : [0, 0, 255]));
  const sources = [{ image: halves, wrapU: 'mirror' }, { factor: [0, 1, 0, 1] }];
  const layout = { uv: SQUARE.texcoords };
  const made = await abflat.bake(mesh, layout, sources, { bakeResolution: 256 });
  // The mirrored image ends as it began.
  assert.deepEqual(pixelOf(made, 20, 250), [255, 0, 0, 255]);
  assert.deepEqual(pixelOf(made, 250, 250), [255, 0, 0, 255]);
  assert.deepEqual(pixelOf(made, 128, 240), [0, 0, 255, 255]);
  assert.deepEqual(pixelOf(made, 20, 40), [0, 255, 0, 255]);
  const moved = { image: halves, offset: [0.5, 0], scale: [0.5, 1] };
  const other = await abflat.bake({ ...mesh, materials: [0, 0] }, layout, moved, {
    bakeResolution: 256,
  });
  assert.deepEqual(pixelOf(other, 60, 128), [0, 0, 255, 255]);
  assert.deepEqual(pixelOf(other, 190, 128), [255, 0, 0, 255]);
});

test('what nothing covers is transparent, or opaque where all is, and padding is not', async () => {
  const uv = SQUARE.texcoords.map((x) => 0.25 + x / 2);
  const image = oneColour(200, 100, 50, 128);
  const bake = (source, options) =>
    abflat.bake(SQUARE, { uv }, source, { bakeResolution: 64, padding: 4, ...options });
  const clear = await bake({ image });
  assert.deepEqual(pixelOf(clear, 32, 32), [200, 100, 50, 128]);
  assert.deepEqual(pixelOf(clear, 13, 32), [200, 100, 50, 128]);
  assert.deepEqual(pixelOf(clear, 2, 2), [0, 0, 0, 0]);
  const opaque = await bake({ image, opaque: true });
  assert.deepEqual(pixelOf(opaque, 32, 32), [200, 100, 50, 255]);
  assert.deepEqual(pixelOf(opaque, 2, 2), [0, 0, 0, 255]);
  const data = await bake({ image }, { kind: 'data' });
  assert.deepEqual(pixelOf(data, 2, 2), [255, 255, 255, 255]);
  // Texels of a layout for 32 are twice as large.
  const wide = await bake({ image }, { layoutResolution: 32 });
  assert.deepEqual(pixelOf(wide, 9, 32), [200, 100, 50, 128]);
  assert.deepEqual(pixelOf(clear, 9, 32), [0, 0, 0, 0]);
});

test('the side is that of the old texels, or of the layout', async () => {
  const side = async (source, options) =>
    (await abflat.bake(SQUARE, { uv: SQUARE.texcoords }, source, options)).width;
  assert.equal(await side({ image: waves(300) }), 256);
  assert.equal(await side({ image: waves(300), scale: [2, 2] }), 512);
  assert.equal(await side({ factor: [1, 0, 0, 1] }), 1024);
  assert.equal(await side({}, { layoutResolution: 128 }), 128);
  assert.equal(await side({ image: waves(300) }, { bakeResolution: 48 }), 48);
});

test('arguments stay as they are, and may be of many kinds', async () => {
  const image = waves(64);
  const before = image.data.slice();
  const mesh = {
    positions: [...SQUARE.positions],
    indices: Uint8Array.from(SQUARE.indices),
    texcoords: Float32Array.from(SQUARE.texcoords),
  };
  const layout = { uv: [...SQUARE.texcoords] };
  const bytes = { ...image, data: new Uint8Array(image.data) };
  const made = await abflat.bake(mesh, layout, [{ image: bytes }]);
  const same = await abflat.bake(SQUARE, { uv: SQUARE.texcoords }, { image });
  assert.deepEqual(made, same);
  assert.deepEqual(image.data, before);
  assert.ok(made.data instanceof Uint8ClampedArray);
});

test('texcoords that a vertex does not have are at 0', async () => {
  const texcoords = SQUARE.texcoords.map((x, i) => (i > 5 ? Number.NaN : x));
  const image = oneColour(10, 20, 30);
  const made = await abflat.bake({ ...SQUARE, texcoords }, { uv: SQUARE.texcoords }, { image });
  assert.deepEqual(pixelOf(made, 4, 4), [10, 20, 30, 255]);
});
