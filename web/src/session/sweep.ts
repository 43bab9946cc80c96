import { type Abflat, AbflatError, type MeshInput, type Report } from 'abflat';
import type { FlattenSettings } from '../model/settings';

/** The report of a layout; null if t is too small for the mesh. */
export async function flattenIfPossible(
  abflat: Abflat,
  input: MeshInput,
  { t, balance, delaunay, bounds }: Omit<FlattenSettings, 'mode'>,
  signal: AbortSignal,
): Promise<Report | null> {
  try {
    return (await abflat.flatten(input, { t, balance, delaunay, bounds, signal })).report;
  } catch (error) {
    if (error instanceof AbflatError && error.code === 'InfeasibleBound') return null;
    throw error;
  }
}
