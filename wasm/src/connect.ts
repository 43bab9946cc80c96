import { buildOf } from './base/build-of.js';
import { type Build, bestBuild, type LateName } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { MAX_MEMORY } from './base/memory.js';
import { startOnce } from './base/start-once.js';
import type { Call } from './call.js';
import {
  compareCall,
  flattenCall,
  inspectCall,
  loadCall,
  packCall,
  pinWeightsCall,
  sampleCall,
  unwrapCall,
} from './calls.js';
import { Client, type ClientSettings, type Lane } from './client.js';
import { fileIn, wasmName } from './file-in.js';
import type { Placed } from './given-modules.js';
import { type LateSettings, lateClient } from './late-client.js';
import { checkFound, checkVersion, moduleFrom } from './load-module.js';
import { ownFields } from './messages/fields.js';
import type { Answer, Description } from './messages/protocol.js';
import {
  checkAddress,
  checkBuild,
  checkMaxMemory,
  isModuleItself,
  KEYS,
  knownOptions,
} from './messages/validate.js';
import type { Address, Platform } from './platform.js';
import type { Abflat, CreateOptions } from './types/index.js';

/** Makes what main calls are given to. */
type MakeLane<L extends Lane> = (platform: Platform, settings: ClientSettings) => L;

export async function connect(platform: Platform, given: CreateOptions = {}): Promise<Abflat> {
  const options = withBuild(platform, knownOptions(given, KEYS.create));
  const { workers, queue, wasmUrl, packUrl, bakeUrl } = options;
  const isUsual = workers === undefined && queue === undefined;
  if (isUsual && ![wasmUrl, packUrl, bakeUrl].some(isModuleItself))
    return open(
      platform,
      options as Placed<CreateOptions>,
      (...settings) => new Client(...settings),
    );
  const { openPool } = await loadRest();
  return openPool(platform, options, open);
}

/** With only one there is no choice. */
function withBuild({ builds }: Platform, options: CreateOptions): CreateOptions {
  checkBuild(options.build, builds);
  const [only] = builds.length === 1 ? builds : [];
  return only === undefined ? options : { ...options, build: only };
}

type Wanted = Pick<CreateOptions, 'build' | 'baseUrl' | 'workerUrl'> & { wasmUrl?: Address };

/** Loads the module, starts a worker and waits until it answers. */
async function open<L extends Lane>(
  platform: Platform,
  options: Placed<CreateOptions>,
  make: MakeLane<L>,
): Promise<Abflat> {
  const { maxMemory = MAX_MEMORY, baseUrl, workerUrl } = options;
  checkMaxMemory(maxMemory);
  for (const name of ['baseUrl', 'wasmUrl', 'packUrl', 'bakeUrl', 'workerUrl'] as const)
    checkAddress(name, options[name]);
  const start = (wanted: Wanted) =>
    startLane(platform, ownFields({ baseUrl, workerUrl, ...wanted, maxMemory }), make);
  // Whatever kept threads from starting, the next build either runs or says what is wrong.
  const { lane, build } = await (isFree(options)
    ? start({ build: 'threads' }).catch(() => start({ build: 'simd' }))
    : start(options));
  const late = (name: LateName): LateSettings => ({
    maxMemory,
    moduleUrl: options[`${name}Url`] ?? fileIn(platform, baseUrl, wasmName(name)),
    workerUrl: workerUrl ?? fileIn(platform, baseUrl, platform.workerFile(name)),
  });
  const baker = startOnce(async () => {
    const { Baker } = await loadRest();
    return new Baker(platform, late('bake'));
  });
  const packer = lateClient(platform, 'pack', late('pack'));
  const run = <T extends Answer>({ request, settings }: Call) => lane.call<T>(request, settings);
  const runPacker = async <T extends Answer>({ request, settings }: Call) => {
    const client = await packer.get();
    client.checkUsable(settings.signal);
    return client.call<T>(request, settings);
  };
  return {
    build,
    flatten: async (mesh, settings = {}) => run(flattenCall(lane, mesh, settings)),
    unwrap: async (mesh, settings = {}) => run(unwrapCall(lane, mesh, settings)),
    pack: async (mesh, settings = {}) => {
      lane.checkUsable();
      // The arguments are read at once, however long the module takes to load.
      return runPacker(packCall(lane, mesh, settings));
    },
    verify: async (mesh, settings = {}) => {
      lane.checkUsable();
      const { verifyCall } = await loadRest();
      return runPacker(verifyCall(lane, mesh, settings));
    },
    bake: async (mesh, layout, sources, settings = {}) => {
      lane.checkUsable();
      return (await baker.get()).bake(mesh, layout, sources, settings);
    },
    compare: async (mesh, settings = {}) => run(compareCall(lane, mesh, settings)),
    inspect: async (mesh, settings = {}) => run(inspectCall(lane, mesh, settings)),
    pinWeights: async (mesh, pins, settings = {}) =>
      run(pinWeightsCall(lane, mesh, pins, settings)),
    load: async (file, settings = {}) => run(loadCall(lane, file, settings)),
    sample: async (name, settings = {}) => run(sampleCall(lane, name, settings)),
    terminate: () => {
      lane.terminate();
      for (const { whenStarted } of [baker, packer]) whenStarted((started) => started.terminate());
    },
  };
}

/**
 * Whether to try the threads build: it seems to run here, and no other build or file was asked for.
 */
function isFree({ build, wasmUrl }: CreateOptions): boolean {
  return build === undefined && wasmUrl === undefined && bestBuild() === 'threads';
}

async function startLane<L extends Lane>(
  platform: Platform,
  options: Wanted & { maxMemory: number },
  make: MakeLane<L>,
): Promise<{ lane: L; build: Build }> {
  const module = await loadModule(platform, options);
  const { maxMemory, baseUrl } = options;
  const name = buildOf(module);
  const workerUrl = options.workerUrl ?? fileIn(platform, baseUrl, platform.workerFile(name));
  const lane = make(platform, { module, name, maxMemory, workerUrl });
  const description = await lane.call<Description>({ kind: 'describe' });
  try {
    checkVersion(description);
  } catch (error) {
    lane.terminate();
    throw error;
  }
  return { lane, build: description.build };
}

/** What few need is not part of what all load. */
async function loadRest(): Promise<typeof import('./rest.js')> {
  try {
    return await import('./rest.js');
  } catch (error) {
    throw new AbflatError(
      'UnreadableFile',
      `Cannot load a part of abflat: ${messageOf(error)}.`,
      'module',
    );
  }
}

/** Loads the file that was named, whichever build it is, or the build that was asked for. */
async function loadModule(
  platform: Platform,
  { build, baseUrl, wasmUrl }: Wanted,
): Promise<WebAssembly.Module> {
  if (build === 'threads') checkThreads(platform);
  const wanted = build ?? bestBuild();
  const address = wasmUrl ?? fileIn(platform, baseUrl, wasmName(wanted));
  const module = await moduleFrom(platform, wanted, address);
  const found = buildOf(module);
  checkFound(found, build, address);
  if (found === 'threads') checkThreads(platform);
  return module;
}

function checkThreads(platform: Platform): void {
  const reason = platform.whyNoThreads();
  if (reason !== undefined)
    throw new AbflatError('InvalidOption', `The threads build cannot run here: ${reason}.`);
}
