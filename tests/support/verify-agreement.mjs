// Whether verify finds what judges find that have none of its code, in random layouts.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { judge as judgeExactly, turn } from './exact-atlas.mjs';
import { DAMAGE_NAMES, layoutText, randomLayout } from './random-layouts.mjs';
import { runAbflat } from './run-abflat.mjs';
import { judge as judgeShared, withoutShared } from './shared.mjs';

/** Damages that now and then do none. */
const MAY_BE_VALID = ['touching', 'pulled'];

/** The counts of `faces` in a report that triangles [[u, v], [u, v], [u, v]] should have, by exact integers. */
export function expectedFaces(triangles) {
  const { flipped, flat, outside } = judgeExactly(triangles);
  const wound = triangles.map((t) => (turn(...t) < 0 ? [t[0], t[2], t[1]] : t));
  const { overlaps } = judgeExactly(wound, { most: Number.POSITIVE_INFINITY });
  return {
    overlapping: new Set(overlaps.flat()).size,
    flipped: flipped.length,
    empty: flat.length,
    outside: outside.length,
  };
}

/** Verifies the layout of each seed, in the folder of `at`; `damage` as of randomLayout. */
export async function agree(at, seeds, damage) {
  for (const seed of seeds) {
    const layout = randomLayout(seed, damage);
    const expected = expectedFaces(
      layout.faces.map((face) => face.map((t) => layout.texcoords[t])),
    );
    writeFileSync(at('in.obj'), layoutText(layout));
    const { code, stderr } = await runAbflat(['verify', 'in.obj', '-q', '--report', 'r.json'], {
      cwd: at(),
    });
    const where = `layout ${seed}, ${damage ?? 'valid'}: ${stderr}`;
    const report = JSON.parse(readFileSync(at('r.json'), 'utf8'));
    assert.deepEqual(report.faces, expected, where);
    const isGood = Object.values(expected).every((count) => count === 0);
    assert.equal(code, isGood ? 0 : 1, where);
    if (!damage) assert.ok(isGood, where);
    if (damage && !MAY_BE_VALID.includes(damage)) assert.ok(!isGood, where);
    if (withoutShared || !layout.isGeneric) continue;
    const { valid, failures } = judgeShared(at('in.obj'), at('in.obj'));
    assert.equal(valid, isGood, `${where} ${failures}`);
  }
}

export const KINDS_OF_LAYOUTS = [undefined, ...DAMAGE_NAMES];

/** Seeds for `count` layouts of a kind: as many valid ones as damaged ones of all kinds. */
export function seedsOf(kind, count) {
  const share = kind ? Math.ceil(count / DAMAGE_NAMES.length) : count;
  return Array.from({ length: share }, (_, i) => 1000 * KINDS_OF_LAYOUTS.indexOf(kind) + i);
}
