// The package with every bundler, on plain and on cross-origin isolated pages: nothing hangs, and
// nothing is silently missing. Installs the bundlers from the npm registry the first time.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { createStaticServer, ISOLATED, listen } from '../../scripts/serve.mjs';
import { startBrowser } from '../../web/scripts/browser.mjs';
import { bin, ENV, FOLDER, INSTALLED, install, project, run } from './project.mjs';

const hasChrome = findChrome() !== undefined;
const NEEDS_CHROME = { skip: hasChrome ? false : 'there is no Chromium' };
/** The build that an isolated page runs. */
const BEST = availableParallelism() > 1 ? 'threads' : 'simd';

let browser;
const ends = [];

before(async () => {
  if (!hasChrome) return;
  install();
  browser = await startBrowser({ webgl: false });
});
after(async () => {
  await browser?.close();
  for (const end of ends) end();
});

const script = (settings = '') => `
import { createAbflat } from 'abflat';
import { unwrapGeometry } from 'abflat/three';
import { TorusKnotGeometry } from 'three';

export async function show() {
  try {
    const abflat = await createAbflat(${settings});
    const { result } = await unwrapGeometry(abflat, new TorusKnotGeometry(1, 0.3, 120, 20));
    return \`\${abflat.build}, valid: \${result.report.valid}\`;
  } catch ({ code, message }) {
    return \`not valid: \${code} \${message}\`;
  }
}
`;
const MAIN =
  "import { show } from './show.js';\nshow().then((text) => (document.body.textContent = text));\n";
const PAGE = `<!doctype html><link rel="icon" href="data:,"><body></body><script type="module" src="./main.js"></script>`;
const files = (settings) => ({
  'package.json': '{ "private": true, "type": "module" }',
  'index.html': PAGE,
  'main.js': MAIN,
  'show.js': script(settings),
});

async function serve(folder, headers) {
  const server = createStaticServer(folder, headers);
  ends.push(() => server.close());
  return `http://127.0.0.1:${await listen(server, '127.0.0.1', 0, false)}`;
}

/** What a page finally shows. */
async function shown(address) {
  const page = await browser.newPage();
  try {
    await page.goto(`${address}/`);
    await page.waitForFunction(() => document.body?.innerText.includes('valid'));
    return await page.innerText('body');
  } finally {
    await page.close();
  }
}

/** Plain pages run `simd`, isolated ones `best`. */
async function assertRuns(folder, best = BEST) {
  assert.equal(await shown(await serve(folder)), 'simd, valid: true');
  assert.equal(await shown(await serve(folder, ISOLATED)), `${best}, valid: true`);
}

async function assertSaysWhatIsMissing(folder) {
  const text = await shown(await serve(folder));
  assert.match(text, /^not valid: UnreadableFile Cannot load \S+abflat-simd\.wasm: 404/);
  assert.match(text, /cp -r node_modules\/abflat\/dist .*baseUrl/);
}

test('webpack', NEEDS_CHROME, async () => {
  const root = project('webpack', files());
  run(bin('webpack'), ['--mode', 'production', '--entry', './main.js', '-o', 'out'], root);
  writeFileSync(join(root, 'out/index.html'), PAGE);
  await assertRuns(join(root, 'out'));
});

test('Vite', NEEDS_CHROME, async () => {
  const root = project('vite', files());
  run(bin('vite'), ['build', '--outDir', 'out', '--logLevel', 'warn'], root);
  await assertRuns(join(root, 'out'));
});

test('Parcel, with threads where the files are copied', NEEDS_CHROME, async () => {
  const build = (root) =>
    run(
      bin('parcel'),
      ['build', 'index.html', '--no-cache', '--cache-dir', 'cache', '--dist-dir', 'out'],
      root,
    );
  const root = project('parcel', files());
  build(root);
  await assertRuns(join(root, 'out'), 'simd');

  const copied = project('parcel-copied', files("{ baseUrl: '/abflat/' }"));
  build(copied);
  cpSync(join(INSTALLED, 'dist'), join(copied, 'out/abflat'), { recursive: true });
  await assertRuns(join(copied, 'out'));
});

const COPIERS = {
  esbuild: ['esbuild', '--bundle', '--format=esm', 'main.js', '--outfile=out/main.js'],
  Rollup: ['rollup', '-p', 'node-resolve', 'main.js', '-d', 'out', '-f', 'es', '--silent'],
};
for (const [name, [program, ...args]] of Object.entries(COPIERS))
  test(
    `${name} says which file is missing, and runs where the files are copied`,
    NEEDS_CHROME,
    async () => {
      const build = (folder, settings) => {
        const root = project(folder, files(settings));
        run(bin(program), args, root);
        writeFileSync(join(root, 'out/index.html'), PAGE);
        return join(root, 'out');
      };
      await assertSaysWhatIsMissing(build(program));
      const out = build(`${program}-copied`, "{ baseUrl: '/abflat/' }");
      cpSync(join(INSTALLED, 'dist'), join(out, 'abflat'), { recursive: true });
      await assertRuns(out);
    },
  );

const next = (config) => ({
  'package.json': '{ "private": true, "type": "module" }',
  'show.js': script(),
  'next.config.mjs': `export default {
    turbopack: { root: ${JSON.stringify(FOLDER)} },
    headers: async () => [{ source: '/:path*', headers: ${JSON.stringify(
      Object.entries(ISOLATED).map(([key, value]) => ({ key, value })),
    )} }],
    ${config}
  };`,
  'app/layout.js':
    'export default ({ children }) => <html lang="en"><body>{children}</body></html>;',
  'app/page.js': `'use client';
    import { useEffect, useState } from 'react';
    import { show } from '../show.js';
    export default function Page() {
      const [text, setText] = useState('');
      useEffect(() => void show().then(setText), []);
      return text;
    }`,
  'app/server/route.js': `import { show } from '../../show.js';
    export const dynamic = 'force-dynamic';
    export const GET = async () => new Response(await show());`,
});

/** Starts `next` as a server; returns its address. */
function start(root) {
  const child = spawn(bin('next'), ['start', '--port', '0'], { cwd: root, env: ENV });
  ends.push(() => child.kill());
  return new Promise((resolve, reject) => {
    let output = '';
    const read = (chunk) => {
      output += chunk;
      const address = output.match(/http:\/\/localhost:\d+/);
      if (address && /Ready/i.test(output)) resolve(address[0]);
    };
    child.stdout.on('data', read);
    child.stderr.on('data', read);
    child.on('exit', () => reject(new Error(output)));
  });
}

const EXTERNAL = "serverExternalPackages: ['abflat'],";
const RUNS = /^simd, valid: true$/;
/** How it is built, its configuration, and what its server then says. */
const NEXT = {
  Turbopack: [['build'], '', RUNS],
  webpack: [['build', '--webpack'], '', /^not valid: UnreadableFile .*serverExternalPackages/],
  'webpack, without the package in the bundle of the server': [
    ['build', '--webpack'],
    EXTERNAL,
    RUNS,
  ],
};
for (const [name, [args, config, answer]] of Object.entries(NEXT))
  test(`Next with ${name}`, NEEDS_CHROME, async () => {
    const root = project(`next-${Object.keys(NEXT).indexOf(name)}`, next(config));
    run(bin('next'), args, root);
    const address = await start(root);
    assert.equal(await shown(address), `${BEST}, valid: true`);
    const response = await fetch(`${address}/server`);
    assert.match(await response.text(), answer);
  });
