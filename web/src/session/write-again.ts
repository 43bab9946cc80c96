import type { Abflat, FlattenResult, KnownLayout, MeshInput, UnwrapResult } from 'abflat';
import { copied } from '../base/buffers';
import type { Outcome } from '../model/model';
import { SAVING } from '../words/export';
import type { ExportFormat } from '../words/generated-formats';
import { layOut } from './lay-out';
import { judged, type Runs, type StackHelpers } from './stacks';

export interface Written {
  obj?: Uint8Array;
  ply?: Uint8Array;
  /** In the precision of the format, of which a GLB has the least. */
  isValid: boolean;
}

/** Asks for another file of a layout that is there. The file has the same coordinates, or there is none. */
export async function writeAgain(
  abflat: Abflat,
  input: MeshInput,
  outcome: Outcome,
  format: ExportFormat,
  helpers: StackHelpers,
  signal: AbortSignal,
): Promise<Written> {
  const { result } = outcome;
  // A chart that is not valid cannot be kept in its place; the same once more gives the same.
  const written =
    result.report.valid || staysInPlace(outcome)
      ? await keepAll(abflat, input, outcome, format, signal)
      : (
          await layOut(
            abflat,
            { ...outcome, input },
            outcome.settings,
            null,
            { signal },
            helpers,
            format,
          )
        ).result;
  if (!isSame(written.indices, result.indices) || !isSame(written.uv, result.uv))
    throw new Error(SAVING.cameOutDifferently);
  const { obj, ply } = written;
  return { obj, ply, isValid: await isValid(written, { abflat, input, helpers, signal }) };
}

async function isValid(written: UnwrapResult | FlattenResult, runs: Runs): Promise<boolean> {
  if (!('chartOfTriangle' in written)) return written.report.valid;
  return (await judged(written, runs)).result.report.valid;
}

/** All charts stay where they are, so nothing is laid out. */
async function keepAll(
  abflat: Abflat,
  input: MeshInput,
  outcome: Outcome,
  format: ExportFormat,
  signal: AbortSignal,
): Promise<UnwrapResult> {
  const { charts } = outcome.result.report;
  return abflat.unwrap(await copied(input), {
    ...atlasOf(outcome),
    known: knownOf(outcome),
    fixedCharts: Uint32Array.from(charts.keys()),
    // They may overlap where the user has moved them.
    keepsPlaces: true,
    seams: 'none',
    ...wanted(format),
    transfer: true,
    signal,
  });
}

/** Whether it is an earlier atlas with charts that were left where they are, or moved. */
export const staysInPlace = ({ mode, result }: Outcome) =>
  mode === 'unwrap' &&
  result.report.charts.some(({ solver, fixed }) => fixed && solver === 'known');

const wanted = (format: ExportFormat) =>
  format === 'glb' ? { roundsForGltf: true } : { [format]: true };

/** What charts that stay must fit in. */
function atlasOf(outcome: Outcome) {
  if (outcome.mode === 'flatten') return {};
  const { resolution, padding, udim, texelDensity, stack } = outcome.settings;
  return { resolution, padding, udim, texelDensity, stack };
}

/** A mesh in one piece is an atlas of one chart. */
function knownOf({ mode, result }: Outcome): KnownLayout {
  if (mode === 'unwrap') return result;
  const { uv, indices, vertexMap } = result;
  return {
    uv,
    unpacked: uv,
    indices,
    vertexMap,
    chartOfTriangle: new Uint32Array(indices.length / 3),
    report: { options: { t: 'auto', straightSeams: false, balance: 0 } },
  };
}

function isSame(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (a[i] !== b[i]) return false;
  return true;
}
