// verify finds just what exact integers find, and an independent judge if it is there.

import { test } from 'node:test';
import { withoutShared } from '../support/shared.mjs';
import { tempFolder } from '../support/temp-folder.mjs';
import { agree, KINDS_OF_LAYOUTS, seedsOf } from '../support/verify-agreement.mjs';

const COUNT = 2000;

for (const kind of KINDS_OF_LAYOUTS)
  test(`random layouts, ${kind ?? 'valid'}`, async (t) => {
    if (withoutShared) t.diagnostic(`no second judge: ${withoutShared}`);
    await agree(tempFolder(t), seedsOf(kind, COUNT), kind);
  });
