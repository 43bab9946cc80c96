// Broken or extreme input: the documented exit code and a sentence, or a valid result.

import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { runAbflat } from '../support/run-abflat.mjs';
import { fan, grid, TETRAHEDRON, TRIANGLE, TWO_TRIANGLES } from '../support/small-meshes.mjs';
import { textStl, trianglesOf } from '../support/stl.mjs';
import { tempFolder } from '../support/temp-folder.mjs';

const HEAD = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n';

const plyText = (points = '0 0 0\n1 0 0\n0 1 0\n', faces = '3 0 1 2\n') =>
  `ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n${points || '0 0 0\n1 0 0\n0 1 0\n'}${faces}`;

/** Name, file, content, exit code, and what the sentence must say. */
const REFUSED = [
  ['OBJ cut off inside a vertex', 'a.obj', `${HEAD}v 1 1`, 3, /a\.obj:4: .*truncated/],
  ['OBJ cut off inside a face', 'a.obj', `${HEAD}f 1 2`, 3, /a\.obj:4: .*2 corners/],
  [
    'OBJ cut off before its last vertices',
    'a.obj',
    `f 1 2 3\n${HEAD.slice(0, 16)}`,
    3,
    /a\.obj:1: .*vertex 3/,
  ],
  ['NaN', 'a.obj', `v 0 0 0\nv nan 0 0\n${TRIANGLE}`, 3, /a\.obj:2: .*(not finite|not a number)/],
  ['infinity', 'a.obj', `v 0 inf 0\n${TRIANGLE}`, 3, /a\.obj:1: .*(not finite|not a number)/],
  ['a number too large for a double', 'a.obj', `v 1e999 0 0\n${TRIANGLE}`, 3, /a\.obj:1: .*finite/],
  ['NaN in OFF', 'a.off', 'OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n', 3, /a\.off:4: /],
  ['a word for a number', 'a.obj', `v 0 zero 0\n${TRIANGLE}`, 3, /a\.obj:1: 'zero'/],
  ['an index out of range', 'a.obj', `${HEAD}f 1 2 7\n`, 3, /a\.obj:4: .*vertex 7/],
  ['index 0', 'a.obj', `${HEAD}f 0 1 2\n`, 3, /a\.obj:4: .*indices start at 1/],
  ['a negative index before the first vertex', 'a.obj', `${HEAD}f -1 -2 -4\n`, 3, /a\.obj:4: /],
  ['an index beyond 64 bits', 'a.obj', `${HEAD}f 1 2 99999999999999999999\n`, 3, /a\.obj:4: /],
  [
    'an OFF index out of range',
    'a.off',
    'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n',
    3,
    /a\.off:6: /,
  ],
  [
    'an OFF header that promises more vertices',
    'a.off',
    TETRAHEDRON.replace('4 4 6', '9 4 6'),
    3,
    /a\.off:\d+: /,
  ],
  [
    'an OFF header that promises more faces',
    'a.off',
    TETRAHEDRON.replace('4 4 6', '4 9 6'),
    3,
    /a\.off:\d+: /,
  ],
  [
    'an OFF header that promises billions',
    'a.off',
    TETRAHEDRON.replace('4 4 6', '4000000000 9 6'),
    3,
    /a\.off:\d+: /,
  ],
  [
    'an OFF header with negative counts',
    'a.off',
    TETRAHEDRON.replace('4 4 6', '-4 4 6'),
    3,
    /a\.off:2: /,
  ],
  [
    'an OFF header that promises fewer faces',
    'a.off',
    TETRAHEDRON.replace('4 4 6', '4 3 6'),
    3,
    /a\.off:10: .*3 faces.*another face/,
  ],
  [
    'NaN in PLY',
    'a.ply',
    plyText('0 0 0\n1 nan 0\n0 1 0\n'),
    3,
    /a\.ply:11: vertex 1 .*not finite/,
  ],
  [
    'a PLY face without such a vertex',
    'a.ply',
    plyText('', '3 0 1 3\n'),
    3,
    /a\.ply:13: .*vertex 3/,
  ],
  [
    'a PLY that promises too much',
    'a.ply',
    plyText().replace('face 1', 'face 2'),
    3,
    /2 elements 'face'/,
  ],
  ['an STL that is cut off', 'a.stl', `${' '.repeat(80)}\x01\0\0\0`, 3, /1 facets.*134 bytes.*84/],
  [
    'an STL facet without area',
    'a.stl',
    `${textStl([
      [
        [0, 0, 0],
        [1, 0, 0],
        [0, 0, 0],
      ],
    ])}`,
    4,
    /twice/,
  ],
  ['an OFF file without counts', 'a.off', 'OFF\n', 3, /a\.off/],
  ['an empty OBJ file', 'a.obj', '', 3, /a\.obj: .*empty/],
  ['an empty OFF file', 'a.off', '', 3, /a\.off.*empty/],
  ['an empty file without an ending', 'a', '', 3, /a: the file is empty/],
  [
    'another format',
    'a.png',
    '\x89PNG\r\n\x1a\n\0\0\0\rIHDR',
    3,
    /a\.png is not supported\. Use OBJ, PLY, STL, OFF, glTF or GLB/,
  ],
  ['vertices without faces', 'a.obj', HEAD, 4, /a\.obj: .*no faces/],
  ['a face that uses a vertex twice', 'a.obj', `${TRIANGLE}f 1 2 2\n`, 4, /face 1 .*twice|face 1 /],
  ['a closed surface', 'a.off', TETRAHEDRON, 4, /a\.off: closed surface/],
  ['two components', 'a.obj', `${TRIANGLE}v 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n`, 4, /2 components/],
  [
    'an edge with three faces',
    'a.obj',
    `${TWO_TRIANGLES}v 0 0 3\nf 2 3 5\n`,
    4,
    /edge .* has 3 faces/,
  ],
  [
    'neighbours that face opposite ways',
    'a.obj',
    TWO_TRIANGLES.replace('3 2 4', '2 3 4'),
    4,
    /orientation/,
  ],
];

for (const [what, file, content, code, sentence] of REFUSED)
  test(`${what} ends with exit code ${code} and a sentence`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at(file), content, 'latin1');
    writeFileSync(at('out.obj'), 'what was there before');
    const run = await runAbflat(['flatten', file, '-o', 'out.obj'], { cwd: at() });
    assert.equal(run.code, code, run.stderr);
    assert.match(run.stderr, sentence);
    assert.match(run.stderr, /^abflat: [^\n]+\n$/, 'one sentence');
    assert.equal(run.stdout, '');
    assert.equal(readFileSync(at('out.obj'), 'utf8'), 'what was there before');
    assert.equal(readdirSync(at()).length, 2);
  });

/** Unusual, but disks. */
const ACCEPTED = [
  ['one triangle', TRIANGLE],
  ['two triangles', TWO_TRIANGLES],
  ['a fan of three', fan(3)],
  ['a fan of twelve', fan(12)],
  ['a flat fan', fan(8, 0)],
  ['a very pointed fan', fan(8, 50)],
  [
    'a face of zero area inside',
    'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 1 0\nv 1 -1 0\nf 1 3 4\nf 1 2 3\nf 1 5 2\nf 2 5 3\n',
  ],
  [
    'a quad and a pentagon',
    'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nf 1 2 3 4\nf 2 5 6 7 3\n',
  ],
  ['a concave polygon', 'v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n'],
  ['Windows line ends and comments', `# one\r\n${TRIANGLE.replaceAll('\n', '\r\n')}# end\r\n`],
  ['negative indices', TRIANGLE.replace('f 1 2 3', 'f -3 -2 -1')],
  ['a vertex without faces', `v 9 9 9\n${TRIANGLE.replace('f 1 2 3', 'f 2 3 4')}`],
  ['no newline at the end', TRIANGLE.trimEnd()],
  ['line ends of old Macs', TRIANGLE.replaceAll('\n', '\r')],
  ['a comment that ends in a backslash', `# C:\\models\\\n${TRIANGLE}`],
];

for (const [what, content] of ACCEPTED)
  test(`${what} gives a valid result`, async (t) => {
    const at = tempFolder(t);
    writeFileSync(at('a.obj'), content);
    for (const bound of ['2', '1']) {
      const args = ['flatten', 'a.obj', '-o', 'out.obj', '--t', bound, '--report', 'r.json'];
      const run = await runAbflat(args, { cwd: at() });
      assert.equal(run.code, 0, run.stderr);
      assert.equal(run.stderr, '');
      assert.equal(JSON.parse(readFileSync(at('r.json'))).valid, true);
      const result = readFileSync(at('out.obj'), 'utf8');
      assert.match(result, /^vt /m);
      assert.doesNotMatch(result, /nan|inf/i);
    }
  });

test('every truncation of a mesh ends with a documented exit code', async (t) => {
  const at = tempFolder(t);
  const texts = {
    'a.obj': grid(2),
    'a.off': TETRAHEDRON,
    'a.ply': plyText('0 0 0\n1 0 0\n0 1 0\n', '3 0 1 2\n'),
    'a.stl': `${textStl(trianglesOf(grid(1)))}`,
  };
  for (const [file, text] of Object.entries(texts))
    for (let length = 0; length < text.length; length += 7) {
      writeFileSync(at(file), text.slice(0, length));
      const run = await runAbflat(['flatten', file, '-o', 'out.obj'], { cwd: at() });
      assert.ok(
        [0, 3, 4].includes(run.code),
        `${file} cut to ${length}: ${run.code} ${run.signal}`,
      );
      assert.equal(run.code === 0, run.stderr === '');
    }
});

test('a file of bounds that cannot be read ends with exit code 3', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('a.obj'), TRIANGLE);
  writeFileSync(at('bad'), '# vertex t\n0 1.5\n1 wide\n');
  mkdirSync(at('folder'));
  for (const [bounds, sentence] of [
    ['missing', /cannot read missing: No such file/],
    ['folder', /cannot read folder: it is a folder/],
    ['bad', /bad:3: expected a vertex number and its t/],
  ]) {
    const args = ['flatten', 'a.obj', '-o', 'out.obj', '--bounds', bounds];
    const run = await runAbflat(args, { cwd: at() });
    assert.equal(run.code, 3);
    assert.match(run.stderr, sentence);
    assert.match(run.stderr, /^abflat: [^\n]+\n$/);
  }
  assert.deepEqual(readdirSync(at()).sort(), ['a.obj', 'bad', 'folder']);
});

test('an input that cannot be opened ends with exit code 3', async (t) => {
  const at = tempFolder(t);
  mkdirSync(at('folder.obj'));
  for (const [input, sentence] of [
    ['missing.obj', /cannot read missing\.obj: No such file/],
    ['folder.obj', /cannot read folder\.obj: it is a folder/],
    ['missing/a.obj', /cannot read missing\/a\.obj/],
  ])
    for (const args of [
      ['inspect', input],
      ['flatten', input, '-o', 'out.obj'],
    ]) {
      const run = await runAbflat(args, { cwd: at() });
      assert.equal(run.code, 3);
      assert.match(run.stderr, sentence);
    }
  assert.deepEqual(readdirSync(at()), ['folder.obj']);
});

test('a bound that no layout can meet is refused with the least possible t', async (t) => {
  const at = tempFolder(t);
  writeFileSync(at('fan.obj'), fan(8));
  const low = await runAbflat(['flatten', 'fan.obj', '-o', 'o.obj', '--t', '0.74'], { cwd: at() });
  assert.equal(low.code, 4);
  assert.match(low.stderr, /fan\.obj: .*0\.75/);
  const least = await runAbflat(['flatten', 'fan.obj', '-o', 'o.obj', '--t', '0.75'], {
    cwd: at(),
  });
  assert.equal(least.code, 0, least.stderr);
});
