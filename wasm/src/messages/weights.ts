// Relative texel densities of meshes.

import { AbflatError } from '../base/errors.js';
import { checkNumber, tagOf } from './validate.js';

/** A mesh that has none has 1; 0 leaves one out. */
export type Weights<M> = ReadonlyMap<M, number> | ((mesh: M) => number | undefined);

export function checkWeights(weights: unknown): void {
  const isKnown =
    weights === undefined || typeof weights === 'function' || tagOf(weights) === 'Map';
  if (isKnown) return;
  throw new AbflatError(
    'InvalidOption',
    'weights must be a Map with numbers of meshes, or a function that returns that of a mesh.',
  );
}

const RANGE = {
  range: 'from 0.001 to 1000, or 0 to leave the mesh out',
  atLeast: 0.001,
  atMost: 1000,
};

/** `name`: of the mesh, in messages. */
export function weightOf<M>(mesh: M, weights: Weights<M> | undefined, name: () => string): number {
  const weight = (typeof weights === 'function' ? weights(mesh) : weights?.get(mesh)) ?? 1;
  if (weight !== 0) checkNumber(`The weight of ${name()}`, weight, RANGE);
  return weight;
}

/** As `faceDensities` for meshes with so many triangles; undefined if all weights are 1. */
export function densitiesFor(
  parts: readonly { weight: number; triangleCount: number }[],
): Float64Array | undefined {
  if (parts.every(({ weight }) => weight === 1)) return undefined;
  const densities = new Float64Array(
    parts.reduce((sum, { triangleCount }) => sum + triangleCount, 0),
  );
  let at = 0;
  for (const { weight, triangleCount } of parts) {
    densities.fill(weight, at, at + triangleCount);
    at += triangleCount;
  }
  return densities;
}
