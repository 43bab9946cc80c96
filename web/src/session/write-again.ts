import type { Abflat, FlattenResult, KnownLayout, MeshInput, UnwrapResult } from 'abflat';
import { copied } from '../base/buffers';
import type { Flattened, Helpers, Outcome, Packed, Unwrapped } from '../model/model';
import { EXPORTED } from '../words/exported';
import type { ExportFormat } from '../words/generated-formats';
import { layOut } from './lay-out';
import { packUvs } from './pack-uvs';
import { judged, type Runs, type StackHelpers } from './stacks';
import { staysInPlace } from './stays-in-place';

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
  helpers: StackHelpers & Pick<Helpers, 'namedParts'>,
  signal: AbortSignal,
): Promise<Written> {
  if (outcome.mode === 'pack') return packAgain(abflat, input, outcome, format, helpers, signal);
  const { result } = outcome;
  // A chart that is not valid cannot be kept in its place; the same once more gives the same.
  const written =
    result.report.valid || staysInPlace(outcome) || hasOwnTiles(outcome)
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
    throw new Error(EXPORTED.cameOutDifferently);
  const { obj, ply } = written;
  return { obj, ply, isValid: await isValid(written, { abflat, input, helpers, signal }) };
}

/** Each format rounds in its own way. */
async function packAgain(
  abflat: Abflat,
  input: MeshInput,
  outcome: Packed,
  format: ExportFormat,
  helpers: Pick<Helpers, 'namedParts'>,
  signal: AbortSignal,
): Promise<Written> {
  const { result } = await packUvs(
    abflat,
    { ...outcome, input },
    outcome.settings,
    { signal },
    helpers,
    format,
  );
  const { uv, indices, obj, ply, report } = result;
  if (!isSame(indices, outcome.result.indices) || !isNear(uv, outcome.result.uv))
    throw new Error(EXPORTED.cameOutDifferently);
  return { obj, ply, isValid: report.valid };
}

/** But for rounding to single precision. */
function isNear(a: Float64Array, b: Float64Array): boolean {
  const most = 2 ** -22;
  return (
    a.length === b.length &&
    a.every((x, i) => Math.abs(x - b[i]) <= most * Math.max(1, Math.abs(b[i])))
  );
}

async function isValid(written: UnwrapResult | FlattenResult, runs: Runs): Promise<boolean> {
  if (!('chartOfTriangle' in written)) return written.report.valid;
  return (await judged(written, runs)).result.report.valid;
}

/** All charts stay where they are, so nothing is laid out. */
async function keepAll(
  abflat: Abflat,
  input: MeshInput,
  outcome: Flattened | Unwrapped,
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

const wanted = (format: ExportFormat) =>
  format === 'glb' ? { roundsForGltf: true } : { [format]: true };

/** What charts that stay must fit in. */
function atlasOf(outcome: Flattened | Unwrapped) {
  if (outcome.mode === 'flatten') return {};
  const { resolution, padding, udim, texelDensity, stack } = outcome.settings;
  const size = { resolution, padding, stack };
  if (!hasOwnTiles(outcome)) return { ...size, udim, texelDensity };
  return { ...size, udim: true, texelDensity: outcome.result.report.atlas.texelDensity };
}

/** Whether its charts lie in tiles of objects or materials. */
const hasOwnTiles = (outcome: Flattened | Unwrapped): boolean =>
  outcome.mode === 'unwrap' &&
  outcome.settings.tiles !== undefined &&
  outcome.result.report.atlas.tiles > 1;

/** A mesh in one piece is an atlas of one chart. */
function knownOf({ mode, result }: Flattened | Unwrapped): KnownLayout {
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
