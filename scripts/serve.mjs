#!/usr/bin/env node
// Serves the built page.
// Usage: serve.mjs [--host ADDRESS] [--port N]   (or PORT in the environment)

import { existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, relative, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { copyFor } from './lib/encodings.mjs';
import { etagOf, names } from './lib/etag.mjs';
import { ROOT, WEB_DIST } from './lib/paths.mjs';
import { Failure, runMain } from './lib/run.mjs';

const DEFAULT_PORT = 4173;
const PORTS_TO_TRY = 20;

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.glb': 'model/gltf-binary',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.map': 'application/json',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.webp': 'image/webp',
  '.woff2': 'font/woff2',
};

/** The file that a request path refers to inside `folder`; undefined if there is none. */
export function fileFor(folder, requestPath) {
  let path;
  try {
    path = decodeURIComponent(requestPath.split(/[?#]/)[0]);
  } catch (error) {
    if (error instanceof URIError) return undefined;
    throw error;
  }
  if (path.includes('\0')) return undefined;
  const full = join(folder, normalize(path.endsWith('/') ? `${path}index.html` : path));
  if (!full.startsWith(folder + sep)) return undefined;
  return existsSync(full) && statSync(full).isFile() ? full : undefined;
}

/** The first of the folders that has the requested path, and the file. */
function find(folders, requestPath) {
  for (const folder of folders) {
    const file = fileFor(folder, requestPath);
    if (file) return { folder, file };
  }
  return {};
}

/**
 * Files that Vite names after their content never change; caching them keeps the page working when
 * the connection is lost.
 */
const FOREVER = 'public, max-age=31536000, immutable';

const isHashed = (folder, file) => relative(folder, file).split(sep)[0] === 'assets';

/** Headers that the page is served with. */
export const HEADERS = JSON.parse(readFileSync(join(ROOT, 'web/headers.json'), 'utf8'));

/**
 * Those that a browser requires of a page that uses threads: it must not load anything from other
 * origins that did not opt in.
 */
export const ISOLATED = Object.fromEntries(
  Object.entries(HEADERS).filter(([name]) => name.startsWith('Cross-Origin')),
);

/** `folders` are searched in order; more may be added later. */
export function createStaticServer(folders, headers = {}) {
  return createServer((request, response) => {
    if (request.method !== 'GET' && request.method !== 'HEAD') {
      response.writeHead(405, { Allow: 'GET, HEAD' }).end();
      return;
    }
    const { folder, file } = find([folders].flat(), request.url);
    if (!file) {
      response.writeHead(404, { 'Content-Type': 'text/plain' }).end('Not found\n');
      return;
    }
    const { path, encoding, varies } = copyFor(file, request.headers['accept-encoding']);
    const tag = etagOf(path);
    const always = {
      ETag: tag,
      'Cache-Control': isHashed(folder, file) ? FOREVER : 'no-cache',
      ...(varies && { Vary: 'Accept-Encoding' }),
      'X-Content-Type-Options': 'nosniff',
      ...headers,
    };
    if (names(request.headers['if-none-match'], tag)) {
      response.writeHead(304, always).end();
      return;
    }
    // Read at once: a build may replace the file while it is sent.
    const bytes = readFileSync(path);
    response.writeHead(200, {
      'Content-Type': TYPES[extname(file)] ?? 'application/octet-stream',
      'Content-Length': bytes.length,
      ...(encoding && { 'Content-Encoding': encoding }),
      ...always,
    });
    response.end(request.method === 'HEAD' ? undefined : bytes);
  });
}

/** Listens on `port`, or with `fallback` on the next free one; returns the port. */
export function listen(server, host, port, fallback) {
  return new Promise((resolve, reject) => {
    let current = port;
    const retry = (error) => {
      if (error.code !== 'EADDRINUSE')
        reject(new Failure(`Cannot serve on ${host}:${current}: ${error.message}`));
      else if (!fallback)
        reject(new Failure(`Port ${current} is in use; choose another: PORT=8080 npm start`));
      else if (current + 1 >= port + PORTS_TO_TRY)
        reject(
          new Failure(
            `Ports ${port} to ${current} are in use; choose another: PORT=8080 npm start`,
          ),
        );
      else server.listen(++current, host);
    };
    server.on('error', retry);
    server.once('listening', () => {
      server.off('error', retry);
      resolve(server.address().port);
    });
    server.listen(current, host);
  });
}

function portOf(text) {
  const port = Number(text);
  if (!Number.isInteger(port) || port < 0 || port > 65535)
    throw new Failure(`"${text}" is not a port number.`);
  return port;
}

/** Serves web/dist, or `folders`, until the process ends; returns the address. `args`: --host [ADDRESS], --port N. */
export async function serve(args, folders = WEB_DIST, { what = 'abflat', headers = HEADERS } = {}) {
  const plain = args.map((arg, i) =>
    arg === '--host' && !isAddress(args[i + 1]) ? '--host=0.0.0.0' : arg,
  );
  const { values } = parseArgs({
    args: plain,
    options: { host: { type: 'string', default: '127.0.0.1' }, port: { type: 'string' } },
  });
  const asked = values.port ?? process.env.PORT;
  const server = createStaticServer(folders, headers);
  const port = await listen(
    server,
    values.host,
    portOf(asked ?? DEFAULT_PORT),
    asked === undefined,
  );
  const shown = ['0.0.0.0', '::', '127.0.0.1'].includes(values.host) ? 'localhost' : values.host;
  const address = `http://${shown}:${port}/`;
  console.log(`\n${what} is at ${address}   (Ctrl+C ends it)`);
  return address;
}

function isAddress(arg) {
  return arg !== undefined && !arg.startsWith('-');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href)
  await runMain(() => serve(process.argv.slice(2)));
