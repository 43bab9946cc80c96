// Modules that callers hand over, compiled or as the bytes of their files, in place of addresses.

import { messageOf } from './base/errors.js';
import { isModuleItself, tagOf } from './messages/validate.js';
import type { Address, Files } from './platform.js';
import type { ModuleOptions, UrlLike } from './types/index.js';

/** Takes the place of an address. */
class Given implements UrlLike {
  readonly href: string;
  readonly source: WebAssembly.Module | BufferSource;

  constructor(option: string, source: WebAssembly.Module | BufferSource) {
    this.href = `the module given as ${option}`;
    this.source = source;
  }

  toString(): string {
    return this.href;
  }

  async compiled(): Promise<WebAssembly.Module> {
    if (tagOf(this.source) === 'WebAssembly.Module') return this.source as WebAssembly.Module;
    try {
      return await WebAssembly.compile(this.source as BufferSource);
    } catch (error) {
      throw new Error(`${this.href} is not a WebAssembly module: ${messageOf(error)}`);
    }
  }
}

/** Options whose modules are at addresses. */
export type Placed<O extends ModuleOptions> = Omit<O, 'wasmUrl' | 'packUrl' | 'bakeUrl'> &
  Partial<Record<'wasmUrl' | 'packUrl' | 'bakeUrl', Address>>;

/** The same options with something that stands for each module. */
export function withoutModules<O extends ModuleOptions>(options: O): Placed<O> {
  const own = { ...options };
  for (const name of ['wasmUrl', 'packUrl', 'bakeUrl'] as const) {
    const source = own[name];
    if (isModuleItself(source)) own[name] = new Given(name, source);
  }
  return own as Placed<O>;
}

/** The same files, and what stands for modules. */
export const withModules = <F extends Files<never>>(files: F): F => ({
  ...files,
  loadModule: ((name, address) =>
    address instanceof Given
      ? address.compiled()
      : files.loadModule(name, address)) satisfies F['loadModule'],
});
