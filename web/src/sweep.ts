import { type Abflat, AbflatError, type MeshInput, type Report } from 'abflat';
import type { Bound } from './format';

/** The report of a layout with this t; null when t is too small for the mesh. */
export async function flattenIfPossible(
  abflat: Abflat,
  input: MeshInput,
  t: Bound,
  signal: AbortSignal,
): Promise<Report | null> {
  try {
    return (await abflat.flatten(input, { t, signal })).report;
  } catch (error) {
    if (error instanceof AbflatError && error.code === 'InfeasibleBound') return null;
    throw error;
  }
}
