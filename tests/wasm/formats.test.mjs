// The package returns the files of the schema, and refuses those that others read.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createAbflat } from 'abflat';
import { coreFormats, filesOf, writtenFormats } from '../../scripts/lib/formats.mjs';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { readSchema } from '../../scripts/lib/read-schema.mjs';
import { grid } from './support/meshes.mjs';

const { formats } = readSchema(ROOT);
const core = coreFormats(formats);
const written = writtenFormats(core).map(({ name }) => name);

let abflat;
before(async () => {
  abflat = await createAbflat();
});
after(() => abflat.terminate());

const filesIn = (result) =>
  Object.keys(result).filter((name) => result[name] instanceof Uint8Array);

test('a layout comes with the files that are asked for, and no others', async () => {
  for (const call of ['flatten', 'unwrap']) {
    assert.deepEqual(filesIn(await abflat[call](grid(3))), []);
    for (const name of written) {
      const result = await abflat[call](grid(3), { [name]: true });
      assert.deepEqual(filesIn(result), [name]);
      const { ending } = filesOf(core).find(({ format }) => format.name === name);
      const again = await abflat.load({ bytes: result[name], name: `again${ending}` });
      assert.equal(again.indices.length, grid(3).indices.length);
    }
    const all = Object.fromEntries(written.map((name) => [name, true]));
    assert.deepEqual(filesIn(await abflat[call](grid(3), all)), written);
    for (const { name } of formats.filter((format) => !written.includes(format.name)))
      await assert.rejects(abflat[call](grid(3), { [name]: true }), /There is no option/);
  }
});

test('files of other libraries are refused by name, and an unknown one is told what to use', async () => {
  for (const { ending } of filesOf(formats.filter(({ library }) => library)))
    await assert.rejects(
      abflat.load({ bytes: new Uint8Array(9), name: `a${ending}` }),
      /is a glTF/,
      ending,
    );
  const unknown = abflat.load({ bytes: new Uint8Array(9), name: 'a.txt' });
  await assert.rejects(unknown, ({ message }) =>
    core.every(({ title }) => message.includes(title)),
  );
});
