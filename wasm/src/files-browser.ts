// How a page finds and reads the package's files.

import type { ModuleName } from './base/builds.js';
import { messageOf } from './base/errors.js';
import { type Address, type FileBeside, type Files, textOf } from './platform.js';

/** Advice if no address was given. */
export const COPY =
  'A bundler may have left it out, as esbuild and Rollup do. Copy the files (cp -r node_modules/abflat/dist public/abflat) ' +
  "and pass their location (createAbflat({ baseUrl: '/abflat/' })).";

const VITE =
  "The development server of Vite cannot find it. Set optimizeDeps: { exclude: ['abflat'] } in vite.config.js.";

const adviceFor = ({ pathname }: URL) => (pathname.includes('/.vite/') ? VITE : COPY);

/** The base of relative addresses. */
const page = () => globalThis.document?.baseURI ?? globalThis.location?.href;

export const addressOf = (address: Address) => new URL(textOf(address), page());

export const browserFiles = <Name extends ModuleName>(beside: FileBeside<Name>): Files<Name> => ({
  fileIn: (folder, name) =>
    new URL(name, new URL(textOf(folder).replace(/\/*$/, '/'), page())).href,

  async loadModule(name, address) {
    const url = address ? addressOf(address) : beside(name);
    const advice = address ? '' : ` ${adviceFor(url)}`;
    const response = await fetchFile(url, advice);
    try {
      return await WebAssembly.compile(await response.arrayBuffer());
    } catch (error) {
      const type = response.headers.get('content-type') ?? 'no type';
      throw new Error(
        `${url} is not a WebAssembly module (served as ${type}): ${messageOf(error)}.${advice}`,
      );
    }
  },
});

async function fetchFile(url: URL, advice: string): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url);
  } catch (error) {
    throw new Error(`Cannot load ${url}: ${messageOf(error)}.${advice}`);
  }
  if (response.ok) return response;
  const status = `${response.status} ${response.statusText}`.trim();
  throw new Error(`Cannot load ${url}: ${status}.${advice}`);
}
