// The generated files match the schema, and any difference is noticed.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  appendFileSync,
  cpSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const REPO = fileURLToPath(new URL('../..', import.meta.url));
const SCHEMA = 'core/schema/abflat.json';
const REPORT_SCHEMA = 'core/schema/report.json';
const FORMATS = 'core/schema/formats.json';
const MANIFEST = 'web/public/manifest.webmanifest';
const OUTPUTS = [
  'core/include/abflat/generated/status_code.h',
  'core/include/abflat/generated/flatten_options.h',
  'wasm/src/base/generated.ts',
  'core/include/abflat/generated/names.h',
  'core/include/abflat/generated/chart_report.h',
  'core/include/abflat/generated/unwrap_report.h',
  'wasm/bindings/generated/field.h',
  'wasm/src/base/generated-report.ts',
  'wasm/src/base/generated-arrays.ts',
  'wasm/src/base/generated-bits.ts',
  'native/python/abflat/_generated.py',
  'core/include/abflat/generated/mesh_format.h',
  'native/src/files/generated/file_format.h',
  'web/src/words/generated-formats.ts',
];

function generate(root, ...args) {
  const script = join(REPO, 'scripts/generate.mjs');
  return spawnSync(process.execPath, [script, '--root', root, ...args], { encoding: 'utf8' });
}

test('generated files of the repository match the schema', () => {
  const { status, stderr } = generate(REPO, '--check');
  assert.equal(status, 0, stderr);
});

describe('in a copy', () => {
  let copy;
  const read = (path) => readFileSync(join(copy, path), 'utf8');
  const write = (path, text) => writeFileSync(join(copy, path), text);

  function changeSchema(change, path = SCHEMA) {
    const schema = JSON.parse(read(path));
    change(schema);
    write(path, JSON.stringify(schema));
  }

  /** Changes a struct of reports. */
  const changeStruct = (name, change) =>
    changeSchema(
      ({ structs }) => change(structs.find((each) => each.name === name)),
      REPORT_SCHEMA,
    );

  before(() => {
    copy = mkdtempSync(join(tmpdir(), 'abflat-generate-'));
  });
  after(() => rmSync(copy, { recursive: true }));

  function fresh() {
    rmSync(copy, { recursive: true });
    mkdirSync(join(copy, 'core'), { recursive: true });
    cpSync(join(REPO, 'core/schema'), join(copy, 'core/schema'), { recursive: true });
    write(
      'README.md',
      'Before\n\n<!-- generated:exit-codes -->\nold\n<!-- /generated -->\n\nAfter\n',
    );
    assert.equal(generate(copy).status, 0);
  }

  test('check passes after generating and writes nothing', () => {
    fresh();
    const { status, stdout } = generate(copy, '--check');
    assert.equal(status, 0);
    assert.equal(stdout, '');
    assert.equal(generate(copy).stdout, '');
  });

  for (const path of OUTPUTS) {
    test(`check fails and names ${path} when it was edited`, () => {
      fresh();
      appendFileSync(join(copy, path), '\n');
      const { status, stderr } = generate(copy, '--check');
      assert.equal(status, 1);
      assert.match(stderr, new RegExp(`^${path} does not match`, 'm'));
    });
  }

  test('a new default reaches C++ and TypeScript', () => {
    fresh();
    changeSchema((schema) => {
      schema.flattenOptions[0].default = 1.25;
    });
    const { status, stderr } = generate(copy, '--check');
    assert.equal(status, 1);
    assert.match(stderr, /flatten_options\.h/);
    assert.match(stderr, /generated\.ts/);
    assert.doesNotMatch(stderr, /status_code\.h/);
    assert.equal(generate(copy).status, 0);
    assert.match(read(OUTPUTS[1]), /\bdouble t = 1\.25;/);
    assert.match(read(OUTPUTS[2]), /\bt: 1\.25,/);
    assert.match(read(OUTPUTS[10]), /"t": OptionInfo\("t", 1\.25, /);
  });

  test('a choice becomes an enum and a union, a word its value', () => {
    fresh();
    changeSchema((schema) => {
      const choices = ['soft', 'hard'].map((name) => ({ name, text: `${name} edges` }));
      const texts = { default: 'hard', text: 'how edges are' };
      schema.flattenOptions.unshift({ name: 'edgeKind', type: 'choice', choices, ...texts });
    });
    assert.equal(generate(copy).status, 0);
    assert.match(read(OUTPUTS[1]), /EdgeKind edgeKind = EdgeKind::Hard;/);
    assert.match(read(OUTPUTS[1]), /"--edge-kind"/);
    assert.match(read(OUTPUTS[1]), /constexpr double kAutoT = 0;/);
    assert.match(read(OUTPUTS[10]), /\bedge_kind: Literal\["soft", "hard"\]/);
    assert.match(read(OUTPUTS[2]), /export type EdgeKind = 'soft' \| 'hard';/);
    assert.match(read(OUTPUTS[2]), /\bt: number \| 'auto';/);
  });

  test('what is for research reaches C++ alone, and comes last', () => {
    fresh();
    mkdirSync(join(copy, 'wasm'), { recursive: true });
    const table = '<!-- generated:flatten-options -->\n<!-- /generated -->\n';
    write('README.md', table);
    write('wasm/README.md', table);
    const choices = ['plain', 'odd'].map((name) => ({ name, text: `${name} steps` }));
    choices[1].research = true;
    const texts = { default: 'plain', text: 'how steps are' };
    const option = { name: 'oddity', type: 'boolean', default: true, text: 'odd', research: true };
    changeSchema(({ flattenOptions }) => {
      flattenOptions.unshift({ name: 'stepKind', type: 'choice', choices, ...texts });
      flattenOptions.push(option);
    });
    assert.equal(generate(copy).status, 0);
    for (const path of [OUTPUTS[1], 'README.md']) assert.match(read(path), /plain, odd.*oddity/s);
    assert.match(read(OUTPUTS[2]), /export type StepKind = 'plain';/);
    for (const path of [OUTPUTS[2], 'wasm/README.md']) assert.doesNotMatch(read(path), /odd/, path);
    changeSchema(({ flattenOptions }) => flattenOptions.unshift(flattenOptions.pop()));
    const { status, stderr } = generate(copy);
    assert.notEqual(status, 0);
    assert.match(stderr, /options: \w+ follows one that is for research/);
  });

  test('an integer refuses fractions and needs bounds', () => {
    fresh();
    const option = { name: 'rounds', type: 'integer', default: 1, atLeast: 0, text: 'how often' };
    changeSchema((schema) => schema.flattenOptions.unshift(option));
    assert.notEqual(generate(copy).status, 0);
    changeSchema((schema) => {
      schema.flattenOptions[0].atMost = 9;
    });
    assert.equal(generate(copy).status, 0);
    assert.match(read(OUTPUTS[1]), /int rounds = 1;/);
    assert.match(
      read(OUTPUTS[1]),
      /value <= 9\) && value == std::trunc\(value\)\)\) return false;/,
    );
    assert.match(read(OUTPUTS[2]), /at least 0 and at most 9, whole/);
  });

  test('a switch that is on by default is switched off by its flag', () => {
    fresh();
    changeSchema((schema) => {
      for (const [name, value] of Object.entries({ softEdges: true, hardEdges: false }))
        schema.flattenOptions.unshift({ name, type: 'boolean', default: value, text: `${name}!` });
    });
    write('README.md', '<!-- generated:flatten-options -->\n<!-- /generated -->\n');
    assert.equal(generate(copy).status, 0);
    assert.match(read(OUTPUTS[1]), /bool softEdges = true;/);
    assert.match(read(OUTPUTS[1]), /"--no-soft-edges", "true", "", "do not softEdges!", true,/);
    assert.match(read(OUTPUTS[1]), /"--hard-edges", "false", "", "hardEdges!", true,/);
    assert.match(read(OUTPUTS[2]), /\bsoftEdges: boolean;/);
    assert.match(read('README.md'), /\| `softEdges` \| `--no-soft-edges` \| `true` \|/);
  });

  test('a default that is no choice is an error', () => {
    fresh();
    changeSchema((schema) => {
      schema.flattenOptions.find(({ type }) => type === 'choice').default = 'sideways';
    });
    assert.match(generate(copy).stderr, /not one of its choices/);
  });

  test('regions of documents are filled, the rest of the document stays', () => {
    fresh();
    const text = read('README.md');
    assert.match(text, /^Before\n\n<!-- generated:exit-codes -->\n\| Exit code \| Meaning \|\n/);
    assert.match(text, /\n<!-- \/generated -->\n\nAfter\n$/);
    for (const { code, text: meaning } of JSON.parse(read(SCHEMA)).exitCodes) {
      assert.ok(text.includes(`| ${code} | ${meaning} |\n`));
    }
  });

  for (const [fault, text, message] of [
    ['an unknown region', '<!-- generated:colours -->\n<!-- /generated -->\n', /colours/],
    ['a region that is not closed', '<!-- generated:statuses -->\ntext\n', /not closed/],
  ]) {
    test(`${fault} is an error`, () => {
      fresh();
      write('README.md', text);
      const { status, stderr } = generate(copy);
      assert.notEqual(status, 0);
      assert.match(stderr, message);
    });
  }

  test('a status with an exit code that does not exist is an error', () => {
    fresh();
    changeSchema((schema) => {
      schema.statuses[1].exit = 77;
    });
    const { status, stderr } = generate(copy);
    assert.notEqual(status, 0);
    assert.match(stderr, /there is no exit code 77/);
  });

  test('a status of the package alone stays out of C++, and comes last', () => {
    fresh();
    changeSchema((schema) => {
      schema.statuses.push({ name: 'NoPencil', in: ['package'], exit: 4, text: 'no pencil' });
    });
    assert.equal(generate(copy).status, 0);
    assert.doesNotMatch(read(OUTPUTS[0]), /NoPencil/);
    assert.match(read(OUTPUTS[2]), /NoPencil: \{ exit: 4, text: 'no pencil' \}/);
    changeSchema((schema) => {
      schema.statuses.unshift(schema.statuses.pop());
    });
    const { status, stderr } = generate(copy);
    assert.notEqual(status, 0);
    assert.match(stderr, /those of the package alone come last/);
  });

  test('a field of a report reaches C++, the JSON, TypeScript and the documents', () => {
    fresh();
    write('README.md', '<!-- generated:struct-PinReport -->\n<!-- /generated -->\n');
    const text = 'mean of these distances';
    changeStruct('PinReport', ({ fields }) =>
      fields.push(
        { name: 'mean', type: 'number', unit: 'radians', null: 'without pins', text },
        {
          name: 'spread',
          type: 'group',
          text: 'how',
          fields: [{ name: 'low', type: 'index', text: 'least' }],
        },
        { name: 'inner', type: 'number', in: ['cpp'], text: 'not told' },
      ),
    );
    assert.equal(generate(copy).status, 0);
    const [header, types, table] = [OUTPUTS[4], OUTPUTS[7], 'README.md'].map(read);
    assert.match(header, /\/\/\/ Mean of these distances, in radians\.\n {2}double mean = 0;/);
    assert.match(
      header,
      /v\.field\("mean", r\.mean\);\n {2}v\.begin\("spread"\);\n {2}v\.field\("low", r\.spreadLow\);\n {2}v\.end\(\);\n}/,
    );
    assert.match(
      types,
      /Mean of these distances, in radians; null without pins\. \*\/\n {2}mean: number \| null;/,
    );
    assert.match(types, /spread: \{ low: number \};/);
    assert.match(
      table,
      /\| `mean` \| number or null, radians \| mean of these distances; null without pins \|/,
    );
    assert.match(header, /double inner = 0;/);
    for (const document of [types, table]) assert.doesNotMatch(document, /inner/);
  });

  test('a field that is like another changes with it', () => {
    fresh();
    changeStruct('ChartReport', ({ fields }) => {
      fields.find(({ name }) => name === 'iterations').type = 'count';
    });
    assert.equal(generate(copy).status, 0);
    for (const path of [OUTPUTS[4], OUTPUTS[5]])
      assert.match(read(path), /std::size_t iterations = 0;/);
  });

  test('a new solver, stage and array reach both sides', () => {
    fresh();
    changeSchema(({ enums, resultArrays }) => {
      const valuesOf = (name) => enums.find((each) => each.name === name).values;
      valuesOf('Solver').push({ name: 'byHand', text: 'a patient person' });
      valuesOf('Stage').push({ name: 'polish', of: ['unwrap'], text: 'polishing' });
      resultArrays.push({ name: 'normals', type: 'number', text: '3 per vertex' });
    }, REPORT_SCHEMA);
    assert.equal(generate(copy).status, 0);
    assert.match(read(OUTPUTS[3]), /case Solver::ByHand:\n {6}return "byHand";/);
    assert.match(read(OUTPUTS[2]), /export type Solver = .*'byHand';/);
    assert.match(read(OUTPUTS[2]), /export type UnwrapStage = .*'polish';/);
    assert.doesNotMatch(read(OUTPUTS[2]), /export type FlattenStage = .*'polish';/);
    assert.match(read(OUTPUTS[5]), /struct UnwrapStages \{[^}]*double polish = 0;/);
    assert.match(read(OUTPUTS[6]), /Normals = 11,.*kFirstFile = 12;/s);
    assert.match(read(OUTPUTS[8]), /normals: \{ field: 11, Kind: Float64Array \},/);
    assert.match(read(OUTPUTS[8]), /obj: \{ field: 12, Kind: Uint8Array \},/);
  });

  test('values that are bits have one each, on both sides', () => {
    fresh();
    changeSchema(({ enums }) => {
      const { values } = enums.find(({ bits }) => bits);
      values.push({ name: 'tiny', text: 'it is smaller than a texel' });
    }, REPORT_SCHEMA);
    assert.equal(generate(copy).status, 0);
    assert.match(read(OUTPUTS[3]), /Outside = 8,.*\n {2}Tiny = 16,/);
    assert.match(
      read('wasm/src/base/generated-bits.ts'),
      /UV_FAULT = \{.* outside: 8, tiny: 16 \} as const;/,
    );
  });

  test('a new array among the options of unwrap reaches both sides', () => {
    fresh();
    changeSchema(({ unwrapArrays }) => {
      unwrapArrays.push({
        name: 'tileOfFace',
        type: 'index',
        of: 'tiles',
        field: 'tiles',
        text: 'the tile of each face',
      });
    }, REPORT_SCHEMA);
    assert.equal(generate(copy).status, 0);
    const header = read('wasm/bindings/generated/unwrap_array.h');
    assert.match(header, /case UnwrapArray::TileOfFace:\n {6}return take\(options\.tiles\);/);
    assert.match(read(OUTPUTS[2]), /tileOfFace\?: Uint32Array;/);
    assert.match(read(OUTPUTS[2]), /tileOfFace: \{ type: 'index', of: 'tiles', multiple: 1 \},/);
  });

  const NEW_FORMAT = {
    name: 'three',
    title: '3MF',
    text: 'a zipped package',
    precision: 'single',
    encoding: 'zipped',
    files: [{ ending: '.3mf', type: 'model/3mf' }],
  };

  test('a format reaches the core, the program, the package, the page and the documents', () => {
    fresh();
    write('README.md', '<!-- generated:formats -->\n<!-- /generated -->\n');
    mkdirSync(join(copy, 'web/public'), { recursive: true });
    cpSync(join(REPO, MANIFEST), join(copy, MANIFEST));
    changeSchema(({ formats }) => formats.splice(2, 0, NEW_FORMAT), FORMATS);
    assert.equal(generate(copy).status, 0);
    const [core, program, page] = OUTPUTS.slice(-3).map(read);
    assert.match(
      core,
      /Three = 2,.*ABFLAT_MESH_FORMATS "OBJ, PLY, 3MF, STL or OFF".*"\.3mf", MeshF/s,
    );
    assert.match(core, /case MeshFormat::Three:\n {6}return Precision::Single;/);
    assert.match(program, /Three = 2,.*return "3MF";.*\{"\.3mf", FileFormat::Three\}/s);
    assert.match(program, /kWrittenEndings = "\.obj, \.ply, \.3mf, \.glb or \.gltf"/);
    assert.match(
      read(OUTPUTS[2]),
      /WRITTEN_FORMATS = \['obj', 'ply', 'three'\].*three\?: boolean;/s,
    );
    assert.match(read(OUTPUTS[8]), /three: \{ field: 13, Kind: Uint8Array \}/);
    assert.match(page, /EXPORT_FORMATS = \['obj', 'ply', '3mf', 'glb'\]/);
    assert.match(page, /ending: '\.3mf', title: '3MF', type: 'model\/3mf', format: 'three'/);
    assert.deepEqual(JSON.parse(read(MANIFEST)).file_handlers[0].accept['model/3mf'], ['.3mf']);
    assert.match(
      read('README.md'),
      /\| 3MF \| a zipped package \| `\.3mf` \| `model\/3mf` \| texcoords in single/,
    );
  });

  test('check fails where the manifest names other files than the formats', () => {
    fresh();
    mkdirSync(join(copy, 'web/public'), { recursive: true });
    write(MANIFEST, readFileSync(join(REPO, MANIFEST), 'utf8').replace('".off"', '".of"'));
    const { status, stderr } = generate(copy, '--check');
    assert.equal(status, 1);
    assert.match(stderr, /^web\/public\/manifest\.webmanifest does not match/m);
  });

  for (const [fault, change, message] of [
    [
      'with the ending of another',
      { files: [{ ending: '.obj', type: 'a/b' }] },
      /\.obj is listed twice/,
    ],
    ['with an ending in capitals', { files: [{ ending: '.OBJ', type: 'a/b' }] }, /bad ending/],
    ['without files', { files: [] }, /format three: it has no files/],
    ['without a type', { files: [{ ending: '.x' }] }, /bad type "undefined" of \.x/],
    ['of unknown precision', { precision: 'half' }, /unknown precision "half"/],
    ['that is written in an unknown encoding', { encoding: undefined }, /it has no encoding/],
    ['that is only read, before one that is written', { precision: undefined }, /ply is too late/],
  ]) {
    test(`a format ${fault} is an error`, () => {
      fresh();
      changeSchema(({ formats }) => formats.splice(1, 0, { ...NEW_FORMAT, ...change }), FORMATS);
      const { status, stderr } = generate(copy);
      assert.notEqual(status, 0);
      assert.match(stderr, message);
    });
  }

  for (const [fault, field, message] of [
    [
      'of an unknown type',
      { name: 'odd', type: 'colour', text: 'x' },
      /PinReport\.odd: unknown type "colour"/,
    ],
    ['without a text', { name: 'odd', type: 'number' }, /PinReport\.odd has no text/],
    [
      'that is there twice',
      { name: 'count', type: 'number', text: 'x' },
      /PinReport: count is listed twice/,
    ],
    [
      'with a key that says nothing',
      { name: 'odd', type: 'text', text: 'x', nul: 'y' },
      /unknown key "nul"/,
    ],
    [
      'of an unknown product',
      { name: 'odd', type: 'text', text: 'x', in: ['page'] },
      /unknown product "page"/,
    ],
    [
      'like one that does not exist',
      'ChartReport.faces',
      /there is no field ChartReport\.faces above it/,
    ],
  ]) {
    test(`a field ${fault} is an error`, () => {
      fresh();
      changeStruct('PinReport', ({ fields }) => fields.push(field));
      const { status, stderr } = generate(copy);
      assert.notEqual(status, 0);
      assert.match(stderr, message);
    });
  }
});
