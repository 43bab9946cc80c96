import { type Abflat, AbflatError, type MeshInput, type Report } from 'abflat';
import type { Settings } from './session';

/** The report of a layout; null when t is too small for the mesh. */
export async function flattenIfPossible(
  abflat: Abflat,
  input: MeshInput,
  settings: Settings,
  signal: AbortSignal,
): Promise<Report | null> {
  try {
    return (await abflat.flatten(input, { ...settings, signal })).report;
  } catch (error) {
    if (error instanceof AbflatError && error.code === 'InfeasibleBound') return null;
    throw error;
  }
}
