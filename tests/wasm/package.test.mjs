// The published package: its size, its files, its documentation.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { createAbflat, SAMPLE_NAMES, STATUS_NAMES, STATUSES } from 'abflat';
import { unwrap } from 'abflat/gltf';
import { withDraco, withMeshopt } from '../support/compressed-by-exporters.mjs';
import {
  addMesh,
  atlasOf,
  emptyDocument,
  flaws,
  io,
  primitiveOf,
  primitivesOf,
  randomRows,
} from '../support/gltf.mjs';
import { madePng } from '../support/made-png.mjs';
import { sphere } from '../support/surfaces.mjs';
import { oneTexture, texturedCube, texturedGlb } from '../support/textured.mjs';
import { EXAMPLE_OBJ, examples } from './support/examples.mjs';
import { DIST, ROOT } from './support/paths.mjs';
import { typesText } from './support/types-text.mjs';

const MAX_KB = 416;
const BUILDS = { simd: 'abflat-simd', threads: 'abflat-threads' };

const IMPORTS = /(?<!['"])\b(?:from|import)\s*\(?\s*['"]([^'"]+)['"]/g;
/** Without those that are loaded later. */
const AT_ONCE = /(?<!['"])\b(?:from|import)\s*['"]([^'"]+)['"]/g;
/** What packs, verifies and bakes, loaded with the first call of each. */
const LATER = /pack|verify|bake/;
const MAX_PACKING_KB = 132;
const MAX_BAKING_KB = 58;

/** The files that a script imports, including itself: `imports` says which. */
function filesFrom(entry, imports = IMPORTS) {
  const files = new Set();
  const visit = (name) => {
    if (files.has(name)) return;
    files.add(name);
    const text = readFileSync(join(DIST, name), 'utf8');
    for (const [, specifier] of text.matchAll(imports)) {
      if (specifier.startsWith('.')) visit(join(dirname(name), specifier));
      else assert.fail(`${name} imports ${specifier}`);
    }
  };
  visit(entry);
  return files;
}

/**
 * Everything that a browser loads for a build: the package, its worker with one of Emscripten's
 * scripts, the module, and the script that threads start with.
 */
function filesOf(build, name) {
  const entries = ['index.js', `worker-${build}.js`];
  const files = [...entries.flatMap((entry) => [...filesFrom(entry, AT_ONCE)]), `${name}.wasm`];
  const starter = `${name}.worker.js`;
  return new Set(existsSync(join(DIST, starter)) ? [...files, starter] : files);
}

for (const [build, name] of Object.entries(BUILDS)) {
  test(`everything that a browser loads for the build ${build} is under ${MAX_KB} KB compressed`, (t) => {
    const files = filesOf(build, name);
    const scripts = [...files].filter((file) => /^abflat(-\w+)?\.js$/.test(file));
    assert.deepEqual(scripts, [`${name}.js`], 'nothing of the other builds');
    assert.deepEqual(
      [...files].filter((file) => LATER.test(file)),
      [],
      'nothing of what packs, verifies or bakes',
    );
    const sum = compressedSize(files);
    t.diagnostic(`${sum} bytes in ${files.size} files`);
    assert.ok(sum < 1024 * MAX_KB, `${sum} bytes`);
  });
}

function compressedSize(files) {
  const bytes = [...files].map((name) => gzipSync(readFileSync(join(DIST, name))).length);
  return bytes.reduce((a, b) => a + b, 0);
}

test(`what the first pack or verify loads is under ${MAX_PACKING_KB} KB compressed`, (t) => {
  const files = [...filesFrom('worker-pack.js'), 'abflat-pack.wasm'];
  const sum = compressedSize(files);
  t.diagnostic(`${sum} bytes in ${files.length} files`);
  assert.ok(sum < 1024 * MAX_PACKING_KB, `${sum} bytes`);
});

test(`what the first bake loads is under ${MAX_BAKING_KB} KB compressed`, (t) => {
  const known = filesFrom('index.js', AT_ONCE);
  const later = [...filesFrom('index.js')].filter((name) => !known.has(name));
  assert.ok(later.includes('rest.js'), `${later}`);
  const files = [...later, ...filesFrom('worker-bake.js'), 'abflat-bake.wasm'];
  const sum = compressedSize(files);
  t.diagnostic(`${sum} bytes in ${files.length} files`);
  assert.ok(sum < 1024 * MAX_BAKING_KB, `${sum} bytes`);
});

test('the entries for browsers import only files of the package', () => {
  assert.ok(filesFrom('index.js').size > 1);
  for (const name of Object.values(BUILDS)) assert.ok(filesFrom('worker.js').has(`${name}.js`));
});

test('what runs in the calling thread imports no worker, and nothing when it is called', () => {
  for (const entry of ['sync.js', 'watlas.js']) {
    const files = [...filesFrom(entry)];
    assert.ok(files.includes('abflat-simd.js') && files.includes('engine.js'));
    assert.deepEqual([...filesFrom(entry, AT_ONCE)].sort(), files.sort());
    for (const name of files)
      assert.doesNotMatch(
        readFileSync(join(DIST, name), 'utf8'),
        /new Worker\(|threads\.wasm/,
        name,
      );
  }
});

test('scripts have the ending that every server knows, and lines that a stack trace can name', () => {
  const scripts = readdirSync(DIST, { recursive: true }).filter((name) => /js$/.test(name));
  for (const name of scripts) {
    assert.match(name, /\.js$/);
    const lines = readFileSync(join(DIST, name), 'utf8').split('\n');
    // Emscripten's output should be small rather than readable.
    if (/^abflat/.test(name)) continue;
    // The module inside is one word.
    const long = lines.filter((line) => line.length >= 1000);
    assert.equal(long.length, name === 'single.js' ? 1 : 0, name);
  }
});

test('the entry for glTF-Transform has types of it alone', () => {
  const inside = readdirSync(join(DIST, 'gltf')).map((name) => `gltf/${name}`);
  const scripts = ['gltf.js', ...inside].filter((name) => name.endsWith('.js'));
  assert.ok(scripts.length > 3);
  for (const name of scripts)
    for (const [, specifier] of readFileSync(join(DIST, name), 'utf8').matchAll(IMPORTS))
      assert.match(specifier, /^\.\.?\//, name);
});

// The other one needs a worker; createAbflat checks there what is checked here.
test('the module knows its label, the status codes and samples of the package', async () => {
  const { Engine } = await import(join(DIST, 'engine.js'));
  const { buildOf } = await import(join(DIST, 'base/build-of.js'));
  const { simd } = await import(join(DIST, 'glue-simd.js'));
  const wasm = await WebAssembly.compile(readFileSync(join(DIST, 'abflat-simd.wasm')));
  const engine = await Engine.create(wasm, 2 ** 28, { simd });
  const { build, statuses, samples } = engine.run({ kind: 'describe' });
  assert.equal(build, buildOf(wasm));
  const own = ['UnsupportedHost'];
  assert.deepEqual([...statuses, ...own], [...STATUS_NAMES]);
  assert.deepEqual(samples, [...SAMPLE_NAMES]);
  assert.deepEqual(Object.keys(STATUSES), [...STATUS_NAMES]);
});

test('version and exported files match the repository', () => {
  const manifest = JSON.parse(readFileSync(join(ROOT, 'wasm/package.json'), 'utf8'));
  const header = readFileSync(join(ROOT, 'core/include/abflat/version.h'), 'utf8');
  assert.equal(manifest.version, header.match(/ABFLAT_VERSION "(\S+)"/)[1]);
  const paths = Object.values(manifest.exports).flatMap((entry) =>
    typeof entry === 'string' ? [entry] : Object.values(entry),
  );
  for (const path of [...paths, manifest.types]) readFileSync(join(ROOT, 'wasm', path));
});

/** Runs code in a separate folder, with more `files`; `check` gets the output and the folder. */
async function runCode(code, check, files = {}) {
  assert.ok(code, 'there is no example');
  const folder = mkdtempSync(join(tmpdir(), 'abflat-readme-'));
  try {
    symlinkSync(join(ROOT, 'node_modules'), join(folder, 'node_modules'));
    writeFileSync(join(folder, 'example.mjs'), code);
    for (const [file, content] of Object.entries({ 'mesh.obj': EXAMPLE_OBJ, ...files }))
      writeFileSync(join(folder, file), content);
    const { status, stdout, stderr } = spawnSync(process.execPath, ['example.mjs'], {
      cwd: folder,
      encoding: 'utf8',
    });
    assert.equal(status, 0, stderr);
    await check(stdout, folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const runExample = (name, check, files) => runCode(examples()[name], check, files);

const writesTexcoords = (pattern) => (stdout, folder) => {
  assert.match(stdout, pattern);
  assert.match(readFileSync(join(folder, 'mesh-uv.obj'), 'utf8'), /^vt /m);
};

test('the examples for Node in the README run, the first of them as a file of the package too', async () => {
  await runExample('node', writesTexcoords(/^true 1 0\.\d+$/m));
  await runExample('node-flatten', writesTexcoords(/^true 0|^true \d\.\d+/m));
  assert.equal(examples().node, readFileSync(join(ROOT, 'wasm/examples/unwrap.mjs'), 'utf8'));
});

test('the example in the README of the repository runs', async () => {
  const { abflat } = examples('README.md');
  await runCode(abflat, (stdout) => assert.match(stdout, /^true \d+ \d+$/m));
});

test('the example of a balance in the README runs: stretch falls', async () => {
  await runExample('balance', (stdout) => {
    const rows = stdout
      .trim()
      .split('\n')
      .map((line) => line.split(' '));
    assert.deepEqual(
      rows.map(([balance]) => balance),
      ['0', '0.2', '1'],
    );
    const stretch = rows.map(([, stretch]) => Number(stretch));
    assert.ok(stretch[0] > stretch[1] && stretch[1] > stretch[2] && stretch[2] >= 1, stdout);
    assert.deepEqual(
      rows.map(([, , energy]) => energy === 'undefined'),
      [true, false, false],
    );
  });
});

test('the example of three.js geometry in the README runs', async () => {
  await runExample('three-unwrap', (stdout) => assert.match(stdout, /^\d+ \d+$/m));
  await runExample('three', () => undefined);
  await runExample('three-scene', (stdout) => {
    const rows = stdout.trim().split('\n');
    assert.deepEqual(
      rows.slice(0, 3).map((row) => row.split(' ').map(Number)),
      [1, 2, 3].map((size) => [Number(rows[0].split(' ')[0]), size]),
    );
    assert.match(rows[3], /^true \d+/);
  });
});

test('the example of glTF in the README runs', async () => {
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(4)));
  const check = async (stdout, folder) => {
    assert.match(stdout, /^true \d+$/m);
    const written = await io.read(join(folder, 'mesh-uv.glb'));
    assert.ok(primitivesOf(written)[0].getAttribute('TEXCOORD_0'));
  };
  await runExample('gltf-unwrap', check, { 'mesh.glb': await io.writeBinary(document) });
});

test('the examples of packing in the README run', async () => {
  await runExample('pack', (stdout) => assert.match(stdout, /^2 \d\.\d+ true$/m));
  const document = emptyDocument();
  const primitive = primitiveOf(document, sphere(4));
  const count = primitive.getAttribute('POSITION').getCount();
  addMesh(
    document,
    'ball',
    primitive.setAttribute('TEXCOORD_0', randomRows(document, 'VEC2', Float32Array, count)),
  );
  const check = async (_, folder) => {
    const written = await io.read(join(folder, 'mesh-packed.glb'));
    assert.ok(primitivesOf(written)[0].getAttribute('TEXCOORD_1'));
  };
  await runExample('gltf-pack', check, { 'mesh.glb': await io.writeBinary(document) });
});

test('the examples of verifying in the README run', async () => {
  await runExample('verify', (stdout) =>
    assert.match(stdout, /^false\noverlapBetween .*faces 0 and 1/m),
  );
  const document = emptyDocument();
  const primitive = primitiveOf(document, sphere(4));
  const count = primitive.getAttribute('POSITION').getCount();
  addMesh(
    document,
    'ball',
    primitive.setAttribute('TEXCOORD_0', randomRows(document, 'VEC2', Float32Array, count)),
  );
  const options = { resolution: 2048, padding: 4 };
  const abflat = await createAbflat();
  await document.transform(unwrap(abflat, { ...options, overwrite: true }));
  abflat.terminate();
  await runExample('gltf-verify', (stdout) => assert.equal(stdout, ''), {
    'mesh.glb': await io.writeBinary(document),
  });
});

test('the examples without a worker, and with several, in the README run', async () => {
  await runExample('sync', (stdout) => assert.match(stdout, /^true \d+$/m));
  await runExample('single', (stdout) => assert.match(stdout, /^true \d+$/m));
  await runExample('pool', (stdout) => assert.match(stdout, /^true 4$/m));
});

test('the example in place of watlas in the README runs', async () => {
  const document = emptyDocument();
  addMesh(document, 'ball', primitiveOf(document, sphere(4)));
  const check = async (_, folder) => {
    const written = await io.read(join(folder, 'mesh-uv.glb'));
    assert.ok(primitivesOf(written)[0].getAttribute('TEXCOORD_1'));
  };
  await runExample('watlas', check, { 'mesh.glb': await io.writeBinary(document) });
});

test('the example of baking in the README runs', async () => {
  await runExample('bake', (stdout) => assert.match(stdout, /^64 16384$/m));
});

test('the example of the textures of a document in the README runs', async () => {
  const png = madePng(32, 32, (x, y) => [8 * x, 8 * y, 100]);
  const mesh = texturedGlb([texturedCube()], oneTexture(png));
  const check = async (stdout, folder) => {
    assert.match(stdout, /^baseColor 32$/m);
    const written = await io.read(join(folder, 'mesh-baked.glb'));
    const [texture, ...others] = written.getRoot().listTextures();
    assert.deepEqual([texture.getSize(), others], [[32, 32], []]);
  };
  await runExample('gltf-bake', check, { 'mesh.glb': mesh });
});

test('the example of compressed glTF in the README runs: the result is uncompressed', async () => {
  for (const compress of [withDraco, withMeshopt]) {
    const document = emptyDocument();
    addMesh(document, 'ball', primitiveOf(document, sphere(4)));
    const check = async (_, folder) => {
      const written = await io.read(join(folder, 'mesh-uv.glb'));
      assert.deepEqual(flaws(atlasOf(primitivesOf(written))), []);
    };
    await runExample('gltf-compressed', check, { 'mesh.glb': await compress(document) });
  }
});

test('the README names every option of unwrapping documents', () => {
  const text = readFileSync(join(ROOT, 'wasm/README.md'), 'utf8');
  const types = readFileSync(join(DIST, 'gltf.d.ts'), 'utf8');
  const baking = readFileSync(join(DIST, 'gltf/bake/bake-document.d.ts'), 'utf8');
  for (const [of, name, least] of [
    [types, 'UnwrapDocumentOptions', 5],
    [baking, 'BakeDocumentOptions', 3],
  ]) {
    const [, body] = of.match(new RegExp(`interface ${name} [^{]*{(.*?)^}`, 'ms'));
    const options = [...body.matchAll(/^ {4}(\w+)\?:/gm)].map(([, option]) => option);
    assert.ok(options.length >= least, `${options}`);
    for (const option of options) assert.ok(text.includes(`| \`${option}\` |`), option);
  }
});

test('the example of a comparison in the README runs', async () => {
  await runExample('compare', (stdout) => {
    assert.match(stdout, /^abflat, t = auto true 0\.\d+$/m);
    assert.match(stdout, /^LSCM, free (true|false) 0\.\d+$/m);
  });
});

test('the README names every status, option and setting', () => {
  const text = readFileSync(join(ROOT, 'wasm/README.md'), 'utf8');
  const types = typesText(DIST, '.d.ts');
  const fields = (name) =>
    [
      ...types
        .match(new RegExp(`interface ${name} [^{]*{(.*?)^}`, 'ms'))[1]
        .matchAll(/^ {4}(\w+)\??[:(]/gm),
    ].map(([, field]) => field);
  const names = [
    'CallOptions',
    'LayoutOptions',
    'PinOptions',
    'FlattenOptions',
    'UnwrapOptions',
    'PackOptions',
    'BakeOptions',
    'BakeMesh',
    'BakeLayout',
    'BakeSource',
    'BakeImage',
    'CreateOptions',
    'Layout<R>',
    'UnwrapResult',
    'PackResult',
    'Comparison',
    'MethodResult',
    'Abflat',
  ];
  for (const field of [...names.flatMap(fields), ...STATUS_NAMES.slice(1)]) {
    assert.ok(text.includes(`\`${field}`), `README.md does not mention ${field}`);
  }
});
