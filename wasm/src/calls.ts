// What each method asks of the module: its arguments, checked and in arrays of its own.

import { AbflatError } from './base/errors.js';
import type { Call, Caller } from './call.js';
import { layoutCall } from './call-layout.js';
import { type Taking, takeArrays, takeFile, takeMesh } from './messages/input.js';
import {
  arraysOf,
  boundNumbers,
  checkBoolean,
  checkFunction,
  checkNumber,
  checkSignal,
  checkString,
  flattenNumbers,
  KEYS,
  knownArrays,
  knownOptions,
  packArrays,
  packNumbers,
  pinNumbers,
  pinnedVertices,
  straightNumbers,
  unwrapNumbers,
} from './messages/validate.js';
import type {
  CallOptions,
  CompareOptions,
  FlattenOptions,
  MeshArrays,
  MeshFile,
  MeshInput,
  PackOptions,
  SampleOptions,
  UnwrapOptions,
} from './types/index.js';

export function flattenCall(caller: Caller, mesh: MeshInput, given: FlattenOptions): Call {
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
  caller.checkUsable();
  return layoutCall(caller, mesh, options, (common) => ({ ...common, ...settings }));
}

export function unwrapCall(caller: Caller, mesh: MeshInput, given: UnwrapOptions): Call {
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
  caller.checkUsable();
  return layoutCall(caller, mesh, options, (common) => ({ ...common, ...settings }), buffers);
}

/** `taking`: the module that packs may not be there yet. */
export function packCall(taking: Taking, mesh: MeshInput, given: PackOptions): Call {
  const options = knownOptions(given, KEYS.pack);
  const arrays = packArrays(options);
  const settings = { kind: 'pack', values: packNumbers(options), arrays } as const;
  const buffers = Object.values(arrays).flatMap((copy) => (copy ? [copy.buffer] : []));
  return layoutCall(taking, mesh, options, (common) => ({ ...common, ...settings }), buffers);
}

export function compareCall(caller: Caller, mesh: MeshInput, options: CompareOptions): Call {
  const { transfer, signal, onProgress } = knownOptions(options, KEYS.compare);
  checkFunction('onProgress', onProgress);
  checkSignal(signal);
  caller.checkUsable(signal);
  const owned = takeMesh(mesh, transfer, caller);
  return {
    request: { kind: 'compare', mesh: owned.mesh, wantsProgress: onProgress !== undefined },
    settings: { transfer: owned.buffers, signal, onProgress },
  };
}

export function inspectCall(caller: Caller, mesh: MeshInput, options: CallOptions): Call {
  const { signal, transfer } = checkCall(caller, options);
  const owned = takeMesh(mesh, transfer, caller);
  const request = { kind: 'inspect', mesh: owned.mesh } as const;
  return { request, settings: { transfer: owned.buffers, signal } };
}

export function pinWeightsCall(
  caller: Caller,
  mesh: MeshArrays,
  pins: readonly number[],
  options: CallOptions,
): Call {
  const { signal, transfer } = checkCall(caller, options);
  const vertices = pinnedVertices(pins);
  const owned = takeArrays(mesh, transfer, caller);
  const request = { kind: 'pinWeights', mesh: owned.mesh, pins: vertices } as const;
  return { request, settings: { transfer: owned.buffers, signal } };
}

export function loadCall(caller: Caller, file: MeshFile, options: CallOptions): Call {
  const { signal, transfer } = checkCall(caller, options);
  const owned = takeFile(file, transfer, caller);
  const request = { kind: 'load', mesh: owned.mesh } as const;
  return { request, settings: { transfer: owned.buffers, signal } };
}

export function sampleCall(caller: Caller, name: string, options: SampleOptions): Call {
  const { detail = 1, signal } = knownOptions(options, KEYS.sample);
  checkNumber('detail', detail, { range: 'from 1', atLeast: 1 });
  checkSignal(signal);
  caller.checkUsable(signal);
  checkString('name', name);
  return { request: { kind: 'sample', name, detail }, settings: { signal } };
}

function checkCall(caller: Caller, given: CallOptions): CallOptions {
  const options = knownOptions(given, KEYS.call);
  checkSignal(options.signal);
  caller.checkUsable(options.signal);
  return options;
}
