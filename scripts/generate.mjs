#!/usr/bin/env node
// Turns core/schema into C++, TypeScript, Python, the marked tables of the documentation, the schema
// of rules for verify, and the files that the manifest of the page accepts. With --check, writes
// nothing: exits with 1 and names the files that differ.

import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import {
  renderField,
  renderNames,
  renderOptions,
  renderStatusCode,
  renderUnwrapArrays,
} from './lib/generate-cpp.mjs';
import { renderReportHeaders } from './lib/generate-cpp-report.mjs';
import { fillRegions } from './lib/generate-docs.mjs';
import {
  fillManifest,
  renderFileFormat,
  renderMeshFormat,
  renderPageFormats,
} from './lib/generate-formats.mjs';
import { renderPython } from './lib/generate-python.mjs';
import { renderRules } from './lib/generate-rules.mjs';
import {
  renderBits,
  renderLateOptions,
  renderOptionTexts,
  renderResultArrays,
  renderTypeScript,
} from './lib/generate-ts.mjs';
import { renderReportTypes } from './lib/generate-ts-report.mjs';
import { readSchema } from './lib/read-schema.mjs';
import { ofProgram, optionSets } from './lib/schema.mjs';

const REPO = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const SCHEMA = 'core/schema';
const MANIFEST = 'web/public/manifest.webmanifest';
const DOC_FOLDERS = ['.', 'docs', 'native', 'wasm', 'web'];

/** Every file that the schema determines, as a map from path to full text. */
export function renderAll(root) {
  const schema = readSchema(root);
  const files = new Map([
    ['core/include/abflat/generated/status_code.h', renderStatusCode(ofProgram(schema))],
    ['core/include/abflat/generated/names.h', renderNames(schema)],
    ...optionSets(ofProgram(schema)).map((set, i, sets) => [
      `core/include/abflat/generated/${set.verb}_options.h`,
      renderOptions(set, sets[i - 1]?.verb),
    ]),
    ...renderReportHeaders(schema).map(([name, text]) => [
      `core/include/abflat/generated/${name}.h`,
      text,
    ]),
    ['core/include/abflat/generated/mesh_format.h', renderMeshFormat(schema)],
    ['native/src/files/generated/file_format.h', renderFileFormat(schema)],
    ['native/python/abflat/_generated.py', renderPython(schema)],
    ['docs/rules.schema.json', renderRules(schema)],
    ['web/src/words/generated-formats.ts', renderPageFormats(schema)],
    ['web/src/words/generated-option-texts.ts', renderOptionTexts(schema)],
    ['wasm/bindings/generated/field.h', renderField(schema)],
    ['wasm/bindings/generated/unwrap_array.h', renderUnwrapArrays(schema)],
    ['wasm/src/base/generated.ts', renderTypeScript(schema)],
    ...renderLateOptions(schema).map(([verb, text]) => [
      `wasm/src/base/generated-${verb}.ts`,
      text,
    ]),
    ['wasm/src/base/generated-report.ts', renderReportTypes(schema)],
    ['wasm/src/base/generated-arrays.ts', renderResultArrays(schema)],
    ['wasm/src/base/generated-bits.ts', renderBits(schema)],
  ]);
  if (existsSync(join(root, MANIFEST)))
    files.set(MANIFEST, fillManifest(readFileSync(join(root, MANIFEST), 'utf8'), schema));
  for (const path of documents(root)) {
    const text = readFileSync(join(root, path), 'utf8');
    const filled = fillRegions(text, schema, path);
    if (filled !== undefined) files.set(path, filled);
  }
  return files;
}

function documents(root) {
  return DOC_FOLDERS.flatMap((folder) => {
    const full = join(root, folder);
    if (!existsSync(full)) return [];
    const names = readdirSync(full).filter((name) => name.endsWith('.md'));
    return names.sort().map((name) => (folder === '.' ? name : `${folder}/${name}`));
  });
}

function drifted(root, files) {
  return [...files].filter(([path, text]) => {
    const full = join(root, path);
    return !existsSync(full) || readFileSync(full, 'utf8') !== text;
  });
}

function write(root, path, text) {
  const full = join(root, path);
  mkdirSync(dirname(full), { recursive: true });
  const temporary = `${full}.${process.pid}.tmp`;
  writeFileSync(temporary, text);
  renameSync(temporary, full);
}

function main() {
  const { values } = parseArgs({
    options: { check: { type: 'boolean' }, root: { type: 'string', default: REPO } },
  });
  const changes = drifted(values.root, renderAll(values.root));
  if (values.check) {
    for (const [path] of changes) console.error(`${path} does not match ${SCHEMA}`);
    if (changes.length > 0) console.error('Run: npm run generate');
    process.exitCode = changes.length > 0 ? 1 : 0;
    return;
  }
  for (const [path, text] of changes) {
    write(values.root, path, text);
    console.log(`wrote ${path}`);
  }
}

main();
