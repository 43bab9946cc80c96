// The engine in the calling thread.

import createBake from './abflat-bake.js';
import createPack from './abflat-pack.js';
import { bakeCall } from './bake-call.js';
import { BakeEngine } from './bake-engine.js';
import { buildOf } from './base/build-of.js';
import { BUILDS, type LateName, type LocalName } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { MAX_MEMORY } from './base/memory.js';
import { packCall } from './calls.js';
import { Engine } from './engine.js';
import { fileIn, wasmName } from './file-in.js';
import { type Placed, withModules, withoutModules } from './given-modules.js';
import type { CreateModule } from './glue.js';
import { simd } from './glue-simd.js';
import type { Instance } from './instantiate.js';
import { lateModule, moduleFrom } from './load-module.js';
import { LocalModule, type Runner, starterOf } from './local-module.js';
import { mainCalls } from './main-calls.js';
import {
  checkAddress,
  checkBuild,
  checkMaxMemory,
  knownOptions,
  OF_CREATE,
  shown,
} from './messages/validate.js';
import { PackEngine } from './pack-engine.js';
import type { Address, Files } from './platform.js';
import type { AbflatSync, CreateSyncOptions } from './types/index.js';
import { verifyCall } from './verify-call.js';

const LATE: readonly LateName[] = ['pack', 'bake'];

export async function connectSync(
  platform: Files<LocalName>,
  given: CreateSyncOptions = {},
): Promise<AbflatSync> {
  const files = withModules(platform);
  const options = withoutModules(knownOptions(given, [...OF_CREATE, 'also']));
  const { maxMemory = MAX_MEMORY } = options;
  checkMaxMemory(maxMemory);
  for (const name of ['baseUrl', 'wasmUrl', 'packUrl', 'bakeUrl'] as const)
    checkAddress(name, options[name]);
  const wanted = wantedOf(options);
  const startLate = async <N extends object>(
    name: LateName,
    create: CreateModule<N>,
    make: (instance: Instance<N>, maxMemory: number) => Runner,
  ): Promise<LocalModule> => {
    const option = `${name}Url` as const;
    const source = options[option] ?? fileIn(files, options.baseUrl, wasmName(name));
    const module = await tellingHow(option, source, lateModule(files, name, source));
    return LocalModule.start(starterOf(module, maxMemory, create, make));
  };
  const [main, pack, bake] = await Promise.all([
    startMain(files, options, maxMemory),
    wanted.has('pack') ? startLate('pack', createPack, PackEngine.of) : undefined,
    wanted.has('bake') ? startLate('bake', createBake, BakeEngine.of) : undefined,
  ]);
  return {
    ...mainCalls(main),
    pack: (mesh, settings = {}) => {
      const packer = there('pack', pack);
      packer.checkUsable();
      return packer.answer(packCall(packer, mesh, settings));
    },
    verify: (mesh, settings = {}) => {
      const packer = there('pack', pack, 'verify');
      packer.checkUsable();
      return packer.answer(verifyCall(packer, mesh, settings));
    },
    bake: (mesh, layout, sources, settings = {}) => {
      const baker = there('bake', bake);
      baker.checkUsable();
      return baker.answer(bakeCall(mesh, layout, sources, settings));
    },
    terminate: () => {
      for (const module of [main, pack, bake]) module?.terminate();
    },
  };
}

function there(
  name: LateName,
  module: LocalModule | undefined,
  call: keyof AbflatSync = name,
): LocalModule {
  if (module) return module;
  throw new AbflatError(
    'InvalidOption',
    `${call} needs a module that was not loaded. Pass also: ['${name}'] to createAbflatSync, or the module itself as ${name}Url.`,
  );
}

/** The modules besides the main one that were asked for, or given. */
function wantedOf({ also = [], ...options }: Placed<CreateSyncOptions>): Set<LateName> {
  const unknown = Array.isArray(also) ? also.find((name) => !LATE.includes(name)) : also;
  if (!Array.isArray(also) || unknown !== undefined)
    throw new AbflatError(
      'InvalidOption',
      `also must be a list of ${LATE.join(', ')}, not ${shown(unknown)}.`,
    );
  return new Set([...also, ...LATE.filter((name) => options[`${name}Url`] !== undefined)]);
}

async function startMain(
  files: Files<LocalName>,
  { build, baseUrl, wasmUrl }: Placed<CreateSyncOptions>,
  maxMemory: number,
): Promise<LocalModule> {
  checkBuild(build, BUILDS);
  if (build === 'threads') throw noThreads();
  const source = wasmUrl ?? fileIn(files, baseUrl, wasmName('simd'));
  const module = await tellingHow('wasmUrl', source, moduleFrom(files, 'simd', source));
  if (buildOf(module) === 'threads') throw noThreads();
  return LocalModule.start(starterOf(module, maxMemory, simd.create, Engine.of));
}

const noThreads = () =>
  new AbflatError(
    'InvalidOption',
    'The threads build cannot run in the calling thread. Use simd, or createAbflat.',
  );

/** Some hosts cannot read files: they import modules, which can be handed over. */
async function tellingHow<T>(
  option: string,
  source: Address | undefined,
  loading: Promise<T>,
): Promise<T> {
  try {
    return await loading;
  } catch (error) {
    if (source !== undefined || !(error instanceof AbflatError)) throw error;
    throw new AbflatError(
      error.code,
      `${messageOf(error)} Where files cannot be loaded, as in workerd, import the module and pass it: createAbflatSync({ ${option}: module }).`,
      error.lost,
    );
  }
}
