// A step of a build: verifies the layouts of all GLB files in a folder, and unwraps those that have
// none. The exit code is 1 if anything was found.
// Usage: node verify-models.mjs FOLDER [RULES.json]   with rules as `abflat verify --rules` takes them

import { readdir, readFile, rename, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { createAbflat } from 'abflat';
import { unwrap, verifyDocument } from 'abflat/gltf';

const [folder = 'models', rulesFile] = process.argv.slice(2);
const { $schema: _, ...rules } = rulesFile ? JSON.parse(await readFile(rulesFile, 'utf8')) : {};
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
const abflat = await createAbflat();

/** Whether any of its triangles has texcoords. */
const isUnwrapped = (document) =>
  document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())
    .some((primitive) => primitive.getAttribute('TEXCOORD_0'));

/** Whoever reads the file meanwhile finds the old one or the new one. */
async function replace(path, bytes) {
  await writeFile(`${path}.tmp`, bytes);
  await rename(`${path}.tmp`, path);
}

/** Unwrapped for the texture that the rules are about, an atlas for each mesh. */
async function unwrapped(document, path) {
  const { resolution, padding = 2 } = rules;
  const options = { ...(resolution && { resolution }), padding: Math.ceil(padding) };
  await document.transform(unwrap(abflat, options));
  await replace(path, await io.writeBinary(document));
}

/** Prints what was found in a file; returns how much. */
async function verified(name) {
  const path = join(folder, name);
  const document = await io.read(path);
  const isNew = !isUnwrapped(document);
  if (isNew) await unwrapped(document, path);
  const atlases = await verifyDocument(abflat, document, { ...rules, groupBy: 'mesh' });
  const findings = atlases.flatMap(({ parts, result }) =>
    result.report.findings.map(({ rule, message }) => ({ rule, message, mesh: parts[0].mesh })),
  );
  const verdict = findings.length === 0 ? 'valid' : `${findings.length} found`;
  console.log(`${name}: ${isNew ? 'unwrapped, ' : ''}${verdict}`);
  for (const { rule, message, mesh } of findings)
    console.log(`  ${mesh.getName() || 'mesh'}: ${rule}: ${message}`);
  return findings.length;
}

for (const name of (await readdir(folder)).sort().filter((name) => /\.glb$/i.test(name)))
  try {
    if ((await verified(name)) > 0) process.exitCode = 1;
  } catch (error) {
    console.error(`${name}: ${error.message}`);
    process.exitCode = 1;
  }
abflat.terminate();
