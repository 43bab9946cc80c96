// The page knows the files of the schema by their names.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { filesOf, namesOf, titleOf, writtenFormats } from '../../scripts/lib/formats.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { readSchema } from '../../scripts/lib/read-schema.mjs';
import { loadModule } from './modules.mjs';

const { formats } = readSchema(ROOT);
const { meshFileOf, exportFormatOf, exportedFile } = await loadModule('base/mesh-files');
const { sourcesOf, noMesh } = await loadModule('opening/chosen-files');

test('every kind of file is a mesh, in any case, and is exported as itself if it can be', () => {
  for (const file of filesOf(formats)) {
    const { ending, format, type } = file;
    for (const name of [`a.b${ending}`, `A${ending.toUpperCase()}`]) {
      assert.equal(meshFileOf(name)?.ending, ending);
      assert.deepEqual(
        sourcesOf([new File([], 'a.png'), new File([], name)]).map((source) => source.name),
        [name],
      );
      const exported = exportedFile(exportFormatOf(name));
      const wanted = format.precision ? format : formats[0];
      assert.deepEqual(
        [exported.format, exported.title],
        [wanted.name, titleOf(filesOf([wanted])[0])],
      );
    }
    assert.equal(meshFileOf(ending).type, type);
  }
  for (const name of ['head', 'obj', 'a.obj.txt']) {
    assert.equal(meshFileOf(name), undefined);
    assert.equal(exportFormatOf(name), writtenFormats(formats)[0].name);
  }
});

test('a file that is no mesh is told every name of a mesh', () => {
  const message = noMesh([new File([], 'a.txt')]);
  for (const name of namesOf(formats)) assert.ok(message.includes(name), message);
});
