// KTX2 textures stay as they are; they cannot be baked, and a sentence says what to do.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { assertValidFile, io } from '../support/gltf.mjs';
import { KTX2_IMAGES, ktx2Cube } from '../support/ktx2-images.mjs';
import { runAbflat } from '../support/run-abflat.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

for (const [kind, image] of Object.entries(KTX2_IMAGES))
  for (const command of ['unwrap', 'pack'])
    test(`${command} keeps ${kind}, and ${command} --bake refuses it`, async (t) => {
      const at = tempFolder(t);
      writeFileSync(at('in.glb'), await ktx2Cube(image));
      const { code } = await runAbflat([command, at('in.glb'), '-o', at('out.glb')]);
      assert.equal(code, 0);
      const document = await io.readBinary(readFileSync(at('out.glb')));
      const root = document.getRoot();
      assert.deepEqual(Buffer.from(root.listTextures()[0].getImage()), image);
      assert.deepEqual(
        root.listExtensionsUsed().map((each) => [each.extensionName, each.isRequired()]),
        [['KHR_texture_basisu', true]],
      );
      await assertValidFile(document);
      const refused = await runAbflat([command, at('in.glb'), '-o', at('baked.glb'), '--bake']);
      assert.equal(refused.code, 3);
      assert.match(
        refused.stderr,
        /in\.glb: images\[0\] is a KTX2 texture, which cannot be read\. Convert it to PNG, such as with 'ktx extract'/,
      );
    });
