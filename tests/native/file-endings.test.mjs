// The program reads and writes the files of the schema, whatever they are called.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { filesOf, listed, namesOf } from '../../scripts/lib/formats.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { readSchema } from '../../scripts/lib/read-schema.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const { formats } = readSchema(ROOT);
const files = filesOf(formats);
const written = files.filter(({ format }) => format.precision);

for (const { ending, format } of files)
  test(`${ending} is ${format.precision ? 'written and read' : 'only read'}`, async (t) => {
    const path = tempFolder(t)(`head${ending}`);
    const { code, stderr } = await runAbflat(['sample', 'head', '-o', path]);
    if (!format.precision) {
      assert.equal(code, 2);
      const endings = listed(written.map((file) => file.ending));
      assert.ok(stderr.includes(`cannot write ${ending} files. Use ${endings}`), stderr);
      return;
    }
    assert.equal(code, 0, stderr);
    assert.ok(readFileSync(path).length > 0);
    for (const name of [path, '-']) {
      const input = name === '-' ? readFileSync(path) : undefined;
      const inspected = await runAbflat(['inspect', name], { input });
      assert.equal(inspected.code, 0, `${name}: ${inspected.stderr}`);
    }
  });

test('the help names all formats, and so does the error for any other', async () => {
  const { stdout } = await runAbflat(['unwrap', '--help']);
  const help = stdout.replace(/\s+/g, ' ');
  assert.ok(help.includes(`mesh to read: ${listed(formats.map(({ title }) => title))};`), help);
  assert.ok(help.includes(`file to write: ${listed(written.map(({ ending }) => ending))};`), help);
  const { stderr } = await runAbflat(['inspect', '-'], { input: 'no mesh' });
  assert.ok(stderr.includes(`is not supported. Use ${listed(namesOf(formats))}`), stderr);
});
