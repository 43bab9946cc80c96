// Compares what JavaScript knows about the module with its C++ source: functions, arguments,
// builds.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from './support/paths.mjs';

const read = (path) => readFileSync(join(ROOT, path), 'utf8');
const API = read('wasm/bindings/main/api.cpp');
const INPUT_API = read('wasm/bindings/input_api.cpp');
const PACK_API = read('wasm/bindings/pack/api.cpp');
const CALLBACKS = read('wasm/bindings/callbacks.cpp');
const BAKE_API = read('wasm/bindings/bake/api.cpp');

/** A C++ type as JavaScript sees it: everything except void and bool is a number. */
const jsType = (type) =>
  /^(void|bool)$/.test(type) ? { void: 'void', bool: 'boolean' }[type] : 'number';

/** "vertex: number", from C++ or TypeScript notation. */
const parameterOf = (text) => {
  const [, type, name] = /^(?:const )?(.*[\s*])(\w+)$/.exec(text.trim());
  return { name, type: jsType(type.trim()) };
};

function functionsOfApi(text) {
  const pattern = /EMSCRIPTEN_KEEPALIVE ([\w:*\s]+?)(\w+)\(([^)]*)\) \{/g;
  return [...text.matchAll(pattern)].map(([, type, name, list]) => ({
    name: `_${name}`,
    type: jsType(type.trim()),
    parameters: list === '' ? [] : list.split(',').map(parameterOf),
  }));
}

/** Of an interface in a file of TypeScript. */
function functionsOf(path, name) {
  const [, body] = read(path).match(new RegExp(`interface ${name} \\{(.*?)^\\}`, 'ms'));
  return [...body.matchAll(/^ {2}(\w+)\(([^)]*)\): (\w+);$/gm)].map(([, method, list, type]) => {
    const parameters = list.split(',').map((each) => each.trim());
    return {
      name: method,
      type,
      parameters: parameters.filter(Boolean).map((each) => each.split(': ')),
    };
  });
}

function assertDeclared(text, path, name) {
  const api = functionsOfApi(text);
  const count = text.match(/^EMSCRIPTEN_KEEPALIVE /gm).length;
  assert.equal(api.length, count, 'every function was read');
  const types = ({ name, type, parameters }) => [
    name,
    type,
    ...parameters.map((each) => each.type),
  ];
  const declared = functionsOf(path, name).map(({ name, type, parameters }) => [
    name,
    type,
    ...parameters.map(([, each]) => each),
  ]);
  assert.deepEqual(declared.sort(), api.map(types).sort());
}

test('the functions of the modules are declared as they are', () => {
  assertDeclared(API, 'wasm/src/native-module.ts', 'NativeModule extends InputModule');
  assertDeclared(INPUT_API, 'wasm/src/input-module.ts', 'InputModule');
  assertDeclared(PACK_API, 'wasm/src/abflat-pack.d.ts', 'PackModule extends InputModule');
  assertDeclared(BAKE_API, 'wasm/src/abflat-bake.d.ts', 'BakeModule');
});

test('what C++ calls takes the arguments that it is given', () => {
  const [, list, call] = CALLBACKS.match(
    /EM_JS\(int, \w+, \((.*?)\), \{\s*return Module\["onProgress"\]\((.*?)\);/s,
  );
  const given = list.split(',').map(parameterOf);
  assert.deepEqual(
    call.split(', '),
    given.map(({ name }) => name),
  );
  const settings = functionsOf('wasm/src/glue.ts', 'NativeSettings').find(
    ({ name }) => name === 'onProgress',
  );
  assert.deepEqual(
    settings.parameters.map(([name, type]) => ({ name, type })),
    given,
  );
});

test('the builds have the names of the package', () => {
  const [, body] = API.match(/abflatBuild\(\) \{(.*?)^\}/ms);
  const names = [...body.matchAll(/return "(\w+)"/g)].map(([, name]) => name);
  const [, list] = read('wasm/src/base/builds.ts').match(/BUILDS\b[^=]*= \[(.*?)\]/s);
  const builds = [...list.matchAll(/'(\w+)'/g)].map(([, name]) => name);
  assert.deepEqual(names.sort(), builds.sort());
});
