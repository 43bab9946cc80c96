// Compares what JavaScript knows about the module with its C++ source: functions, arguments,
// builds.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { ROOT } from './support/paths.mjs';

const read = (path) => readFileSync(join(ROOT, path), 'utf8');
const API = read('wasm/bindings/api.cpp');
const DECLARATIONS = read('wasm/src/abflat.d.ts');

/** A C++ type as JavaScript sees it: everything except void and bool is a number. */
const jsType = (type) =>
  /^(void|bool)$/.test(type) ? { void: 'void', bool: 'boolean' }[type] : 'number';

/** "vertex: number", from C++ or TypeScript notation. */
const parameterOf = (text) => {
  const [, type, name] = /^(?:const )?(.*[\s*])(\w+)$/.exec(text.trim());
  return { name, type: jsType(type.trim()) };
};

function functionsOfApi() {
  const pattern = /EMSCRIPTEN_KEEPALIVE ([\w:*\s]+?)(\w+)\(([^)]*)\) \{/g;
  return [...API.matchAll(pattern)].map(([, type, name, list]) => ({
    name: `_${name}`,
    type: jsType(type.trim()),
    parameters: list === '' ? [] : list.split(',').map(parameterOf),
  }));
}

function functionsOf(name) {
  const [, body] = DECLARATIONS.match(new RegExp(`interface ${name} \\{(.*?)^\\}`, 'ms'));
  return [...body.matchAll(/^ {2}(\w+)\(([^)]*)\): (\w+);$/gm)].map(([, method, list, type]) => ({
    name: method,
    type,
    parameters: list === '' ? [] : list.split(', ').map((each) => each.split(': ')),
  }));
}

test('the functions of the module are declared as they are', () => {
  const api = functionsOfApi();
  const count = API.match(/^EMSCRIPTEN_KEEPALIVE /gm).length;
  assert.equal(api.length, count, 'every function was read');
  const types = ({ name, type, parameters }) => [
    name,
    type,
    ...parameters.map((each) => each.type),
  ];
  const declared = functionsOf('NativeModule').map(({ name, type, parameters }) => [
    name,
    type,
    ...parameters.map(([, each]) => each),
  ]);
  assert.deepEqual(declared.sort(), api.map(types).sort());
});

test('what C++ calls takes the arguments that it is given', () => {
  const [, list, call] = API.match(
    /EM_JS\(void, \w+, \((.*?)\), \{\s*Module\["onProgress"\]\((.*?)\);/s,
  );
  const given = list.split(',').map(parameterOf);
  assert.deepEqual(
    call.split(', '),
    given.map(({ name }) => name),
  );
  const settings = functionsOf('NativeSettings').find(({ name }) => name === 'onProgress');
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
