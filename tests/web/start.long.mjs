// The first `npm start`: the page is available once one module is built, and gets the others when
// they are ready. The compilers are fakes that hand over the modules already built in this
// repository, all but the first only when released.

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { after, before, test } from 'node:test';
import { ROOT } from '../../scripts/lib/paths.mjs';
import { findChrome } from '../../scripts/lib/requirements.mjs';
import { newContext, startBrowser } from '../../web/scripts/browser.mjs';

const NEEDS_CHROME = { skip: findChrome() ? false : 'there is no Chromium' };

/** A fake cmake that can be called to configure and to build. */
const CMAKE = `#!/usr/bin/env node
const { appendFileSync, copyFileSync, existsSync, mkdirSync, readdirSync, writeFileSync } = require('node:fs');
const { basename, join } = require('node:path');
const [root, played] = ${JSON.stringify([ROOT, 'PLAYED'])};
const args = process.argv.slice(2);
appendFileSync(join(played, 'calls'), args.join(' ') + '\\n');
const after = (name) => args[args.indexOf(name) + 1];
if (args[0] === '--build') {
  const modules = join(root, 'build', basename(args[1]));
  const deliver = () => {
    for (const name of readdirSync(modules).filter((each) => /^abflat.*\\.(mjs|js|wasm)$/.test(each)))
      copyFileSync(join(modules, name), join(args[1], name));
  };
  const wait = () => (existsSync(join(played, 'go')) ? deliver() : setTimeout(wait, 100));
  if (basename(args[1]) === 'wasm') deliver();
  else wait();
} else {
  const defines = args.filter((arg) => arg.startsWith('-D')).map((arg) => arg.slice(2).replace('=', ':STRING='));
  mkdirSync(after('-B'), { recursive: true });
  writeFileSync(join(after('-B'), 'build.ninja'), '');
  const cache = ['CMAKE_HOME_DIRECTORY:INTERNAL=' + after('-S'), ...defines];
  writeFileSync(join(after('-B'), 'CMakeCache.txt'), cache.join('\\n') + '\\n');
}
`;

let folder;
let copy;
let server;

/**
 * The repository without anything built; npm packages are linked from here, except the package and
 * the page, which are the copy's own.
 */
function copyRepository() {
  const { stdout } = spawnSync(
    'git',
    ['ls-files', '-z', '--cached', '--others', '--exclude-standard'],
    {
      cwd: ROOT,
      encoding: 'utf8',
    },
  );
  for (const file of stdout.split('\0').filter((name) => name && existsSync(join(ROOT, name))))
    cpSync(join(ROOT, file), join(copy, file));
  mkdirSync(join(copy, 'node_modules'));
  for (const name of readdirSync(join(ROOT, 'node_modules'))) {
    const target = { abflat: '../wasm', 'abflat-web': '../web' }[name];
    symlinkSync(target ?? join(ROOT, 'node_modules', name), join(copy, 'node_modules', name));
  }
}

function playCompilers() {
  const bin = join(folder, 'bin');
  mkdirSync(bin);
  writeFileSync(join(bin, 'cmake'), CMAKE.replace('PLAYED', folder), { mode: 0o755 });
  writeFileSync(join(bin, 'emcmake'), '#!/bin/sh\nexec "$@"\n', { mode: 0o755 });
  return bin;
}

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'abflat-start-'));
  copy = join(folder, 'copy');
  copyRepository();
});
after(() => {
  server?.kill();
  rmSync(folder, { recursive: true });
});

/** Runs `npm start`; `said` resolves once its output matches. */
function start() {
  server = spawn(process.execPath, ['scripts/start.mjs', '--port', '0'], {
    cwd: copy,
    env: { ...process.env, PATH: `${playCompilers()}${delimiter}${process.env.PATH}` },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  let text = '';
  const waiting = new Set();
  const hear = (chunk) => {
    text += chunk;
    for (const look of waiting) look();
  };
  server.stdout.on('data', hear);
  server.stderr.on('data', hear);
  return (pattern) =>
    new Promise((resolve, reject) => {
      const look = () => {
        const match = text.match(pattern);
        if (match) {
          waiting.delete(look);
          resolve(match);
        }
      };
      waiting.add(look);
      server.on('exit', () => reject(new Error(`it ended:\n${text}`)));
      look();
    });
}

/** Loads the page and waits for the layout of its sample. Returns the modules that the running one was chosen from. */
async function loadPage(page, address) {
  await page.goto(address);
  await page.waitForFunction(
    () => document.querySelector('#run-text').textContent !== 'Starting' && !document.body.ariaBusy,
  );
  assert.equal(await page.locator('#alert').innerText(), '');
  return page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({ name }) => name.match(/abflat[\w-]*?(?=-[\w-]{8}\.wasm$)/)?.[0])
      .filter(Boolean),
  );
}

test(
  'the page works with the first module, and with all once they are built',
  NEEDS_CHROME,
  async () => {
    const said = start();
    const [, address] = await said(/abflat is at (http:\S+)/);
    const browser = await startBrowser();
    const page = await (await newContext(browser)).newPage();
    page.setDefaultTimeout(120_000);
    const problems = [];
    page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
    page.on('pageerror', (error) => problems.push(String(error)));
    const first = await loadPage(page, address);
    const script = await page.evaluate(() => document.querySelector('script[src]').src);
    assert.ok(existsSync(join(copy, 'build/wasm/abflat.wasm')), first.join());
    assert.ok(!existsSync(join(copy, 'build/wasm-threads/abflat-threads.wasm')));
    writeFileSync(join(folder, 'go'), '');
    await said(/All is built: load http:\S+ again/);
    assert.equal((await fetch(script)).status, 200, 'a page that is open keeps its files');
    assert.deepEqual(await loadPage(page, address), ['abflat-threads']);
    await browser.close();
    assert.deepEqual(problems, []);
    const calls = readFileSync(join(folder, 'calls'), 'utf8');
    assert.doesNotMatch(calls, /build\/native/, 'the page needs no native program');
  },
);
