import { buildOf } from './base/build-of.js';
import { type Build, bestBuild, type LateName, whyNoThreads } from './base/builds.js';
import { AbflatError, messageOf } from './base/errors.js';
import { STATUS_NAMES } from './base/generated.js';
import { MAX_MEMORY } from './base/memory.js';
import { startOnce } from './base/start-once.js';
import { layoutCall } from './call-layout.js';
import { Client } from './client.js';
import { type LateClient, type LateSettings, lateClient } from './late-client.js';
import { ownFields } from './messages/fields.js';
import { takeArrays, takeFile, takeMesh } from './messages/input.js';
import type { Description } from './messages/protocol.js';
import {
  arraysOf,
  boundNumbers,
  checkAddress,
  checkBoolean,
  checkBuild,
  checkFunction,
  checkMaxMemory,
  checkNumber,
  checkSignal,
  checkString,
  flattenNumbers,
  KEYS,
  knownArrays,
  knownOptions,
  packNumbers,
  pinNumbers,
  pinnedVertices,
  straightNumbers,
  unwrapNumbers,
} from './messages/validate.js';
import type { Address, Platform } from './platform.js';
import type {
  Abflat,
  CallOptions,
  CompareOptions,
  Comparison,
  CreateOptions,
  FlattenOptions,
  FlattenResult,
  LoadedMesh,
  MeshArrays,
  MeshFile,
  MeshInput,
  MeshSummary,
  PackOptions,
  PackResult,
  PinWeights,
  SampleOptions,
  TriangleMesh,
  UnwrapOptions,
  UnwrapResult,
} from './types/index.js';
import { wasmName } from './wasm-file.js';

/** Loads the module, starts a worker and waits until it answers. */
export async function connect(platform: Platform, given: CreateOptions = {}): Promise<Abflat> {
  const options = knownOptions(given, KEYS.create);
  const { maxMemory = MAX_MEMORY, baseUrl, workerUrl } = options;
  checkMaxMemory(maxMemory);
  for (const name of ['baseUrl', 'wasmUrl', 'packUrl', 'bakeUrl', 'workerUrl'] as const)
    checkAddress(name, options[name]);
  const start = (wanted: Pick<CreateOptions, 'build' | 'wasmUrl'>) =>
    startClient(platform, ownFields({ baseUrl, workerUrl, ...wanted, maxMemory }));
  // Whatever kept threads from starting, the next build either runs or says what is wrong.
  const { client, build } = await (isFree(options)
    ? start({ build: 'threads' }).catch(() => start({ build: 'simd' }))
    : start(options));
  const late = (name: LateName): LateSettings => ({
    maxMemory,
    moduleUrl: options[`${name}Url`] ?? fileIn(platform, baseUrl, wasmName(name)),
    workerUrl: workerUrl ?? fileIn(platform, baseUrl, platform.workerFile(name)),
  });
  const baker = startOnce(async () => {
    const { Baker } = await loadBaker();
    return new Baker(platform, late('bake'));
  });
  const packer = lateClient(platform, 'pack', late('pack'));
  return {
    build,
    flatten: async (mesh, settings = {}) => flatten(client, mesh, settings),
    unwrap: async (mesh, settings = {}) => unwrap(client, mesh, settings),
    pack: async (mesh, settings = {}) => {
      client.checkUsable();
      return pack(packer, mesh, settings);
    },
    bake: async (mesh, layout, sources, settings = {}) => {
      client.checkUsable();
      return (await baker.get()).bake(mesh, layout, sources, settings);
    },
    compare: async (mesh, settings = {}) => compare(client, mesh, settings),
    inspect: async (mesh, settings = {}) => inspect(client, mesh, settings),
    pinWeights: async (mesh, pins, settings = {}) => pinWeights(client, mesh, pins, settings),
    load: async (file, settings = {}) => load(client, file, settings),
    sample: async (name, settings = {}) => sample(client, name, settings),
    terminate: () => {
      client.terminate();
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

async function startClient(
  platform: Platform,
  options: CreateOptions & { maxMemory: number },
): Promise<{ client: Client; build: Build }> {
  const module = await loadModule(platform, options);
  const { maxMemory, baseUrl } = options;
  const name = buildOf(module);
  const workerUrl = options.workerUrl ?? fileIn(platform, baseUrl, platform.workerFile(name));
  const client = new Client(platform, { module, name, maxMemory, workerUrl });
  const { build, statuses } = await client.call<Description>({ kind: 'describe' });
  if (statuses.join() === STATUS_NAMES.join()) return { client, build };
  client.terminate();
  throw new AbflatError(
    'Internal',
    'The versions of abflat.wasm and abflat differ. Use files of one version.',
  );
}

/** What bakes is not part of what all load. */
async function loadBaker(): Promise<typeof import('./baker.js')> {
  try {
    return await import('./baker.js');
  } catch (error) {
    throw new AbflatError(
      'UnreadableFile',
      `Cannot load the part of abflat that bakes: ${messageOf(error)}.`,
      'module',
    );
  }
}

function fileIn(platform: Platform, folder: Address | undefined, name: string): string | undefined {
  if (!folder) return undefined;
  try {
    return platform.fileIn(folder, name);
  } catch (error) {
    throw new AbflatError('InvalidOption', `baseUrl is not a valid URL: ${messageOf(error)}.`);
  }
}

/** Loads the file that was named, whichever build it is, or the build that was asked for. */
async function loadModule(
  platform: Platform,
  { build, baseUrl, wasmUrl }: CreateOptions,
): Promise<WebAssembly.Module> {
  checkBuild(build);
  if (build === 'threads') checkThreads();
  const wanted = build ?? bestBuild();
  const address = wasmUrl ?? fileIn(platform, baseUrl, wasmName(wanted));
  const module = await platform.loadModule(wanted, address).catch((error: unknown) => {
    throw new AbflatError('UnreadableFile', messageOf(error), 'module');
  });
  const found = buildOf(module);
  if (build !== undefined && build !== found)
    throw new AbflatError('InvalidOption', `build is ${build}, but ${address} is ${found}.`);
  if (found === 'threads') checkThreads();
  return module;
}

function checkThreads(): void {
  const reason = whyNoThreads();
  if (reason !== undefined)
    throw new AbflatError('InvalidOption', `The threads build cannot run here: ${reason}.`);
}

function flatten(client: Client, mesh: MeshInput, given: FlattenOptions): Promise<FlattenResult> {
  const options = knownOptions(given, KEYS.flatten);
  const { normalize } = options;
  checkBoolean('normalize', normalize);
  const pins = pinNumbers(options.pins);
  if (normalize && pins.length > 0)
    throw new AbflatError('InvalidOption', 'normalize would move the pins. Use only one of them.');
  const settings = {
    kind: 'flatten',
    values: flattenNumbers(options),
    pins,
    bounds: boundNumbers(options.bounds),
    straight: straightNumbers(options.straight),
    normalizes: normalize === true,
  } as const;
  client.checkUsable();
  const call = layoutCall(mesh, options, (common) => ({ ...common, ...settings }));
  return client.call<FlattenResult>(call.request, call.settings);
}

function unwrap(client: Client, mesh: MeshInput, given: UnwrapOptions): Promise<UnwrapResult> {
  const options = knownOptions(given, KEYS.unwrap);
  const { seams } = options;
  if (seams !== undefined) checkString('seams', seams);
  const { keepsPlaces = false, keepsValidOnly = false } = options;
  checkBoolean('keepsPlaces', keepsPlaces);
  checkBoolean('keepsValidOnly', keepsValidOnly);
  const arrays = arraysOf(options);
  const wantsUv = options.fixedCharts?.length ? 'fixedCharts' : keepsPlaces && 'keepsPlaces';
  const known = knownArrays(options.known, wantsUv);
  const settings = {
    kind: 'unwrap',
    values: unwrapNumbers(options),
    pins: pinNumbers(options.pins),
    seams,
    arrays,
    keepsUv: options.fixedFaces === 'uv',
    keepsValidOnly,
    keepsPlaces,
    known,
  } as const;
  const copies = [...arrays, ...Object.values(known?.arrays ?? {})];
  const buffers = copies.flatMap((copy) => (copy ? [copy.buffer as ArrayBuffer] : []));
  client.checkUsable();
  const call = layoutCall(mesh, options, (common) => ({ ...common, ...settings }), buffers);
  return client.call<UnwrapResult>(call.request, call.settings);
}

/** The arguments are read at once, however long the module takes to load. */
async function pack(packer: LateClient, mesh: MeshInput, given: PackOptions): Promise<PackResult> {
  const options = knownOptions(given, KEYS.pack);
  const settings = { kind: 'pack', values: packNumbers(options) } as const;
  const call = layoutCall(mesh, options, (common) => ({ ...common, ...settings }));
  const client = await packer.get();
  client.checkUsable(options.signal);
  return client.call<PackResult>(call.request, call.settings);
}

function compare(client: Client, mesh: MeshInput, options: CompareOptions): Promise<Comparison> {
  const { transfer, signal, onProgress } = knownOptions(options, KEYS.compare);
  checkFunction('onProgress', onProgress);
  checkSignal(signal);
  client.checkUsable(signal);
  const owned = takeMesh(mesh, transfer);
  return client.call<Comparison>(
    { kind: 'compare', mesh: owned.mesh, wantsProgress: onProgress !== undefined },
    { transfer: owned.buffers, signal, onProgress },
  );
}

function inspect(client: Client, mesh: MeshInput, options: CallOptions): Promise<MeshSummary> {
  const { signal, transfer } = checkCall(client, options);
  const owned = takeMesh(mesh, transfer);
  const request = { kind: 'inspect', mesh: owned.mesh } as const;
  return client.call<MeshSummary>(request, { transfer: owned.buffers, signal });
}

function pinWeights(
  client: Client,
  mesh: MeshArrays,
  pins: readonly number[],
  options: CallOptions,
): Promise<PinWeights> {
  const { signal, transfer } = checkCall(client, options);
  const vertices = pinnedVertices(pins);
  const owned = takeArrays(mesh, transfer);
  const request = { kind: 'pinWeights', mesh: owned.mesh, pins: vertices } as const;
  return client.call<PinWeights>(request, { transfer: owned.buffers, signal });
}

function load(client: Client, file: MeshFile, options: CallOptions): Promise<LoadedMesh> {
  const { signal, transfer } = checkCall(client, options);
  const owned = takeFile(file, transfer);
  const request = { kind: 'load', mesh: owned.mesh } as const;
  return client.call<LoadedMesh>(request, { transfer: owned.buffers, signal });
}

function checkCall(client: Client, given: CallOptions): CallOptions {
  const options = knownOptions(given, KEYS.call);
  checkSignal(options.signal);
  client.checkUsable(options.signal);
  return options;
}

function sample(client: Client, name: string, options: SampleOptions): Promise<TriangleMesh> {
  const { detail = 1, signal } = knownOptions(options, KEYS.sample);
  checkNumber('detail', detail, { range: 'from 1', atLeast: 1 });
  checkSignal(signal);
  client.checkUsable(signal);
  checkString('name', name);
  return client.call<TriangleMesh>({ kind: 'sample', name, detail }, { signal });
}
