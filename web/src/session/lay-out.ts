import type { Abflat, AbflatError, UnwrapOptions } from 'abflat';
import { copied } from '../base/buffers';
import { loadPart } from '../base/load-part';
import { exportFormatOf } from '../base/mesh-files';
import { isMisplaced } from '../model/misplaced';
import type { AnyProgress, Flattened, Helpers, Opened, Outcome, Unwrapped } from '../model/model';
import type { NamedPart } from '../model/named-parts';
import { type FlattenSettings, sameButSeams, type UnwrapSettings } from '../model/settings';
import { stackedCharts, stacksIn, withStacks } from '../model/stacks';
import type { ExportFormat } from '../words/generated-formats';
import type { StackHelpers } from './stacks';

/** What judges and keeps charts that were moved is not part of the first load. */
export const stackParts = () => loadPart(import('./stacks'));

interface Watch {
  signal: AbortSignal;
  onProgress?: (progress: AnyProgress) => void;
}

type Input = Pick<Opened, 'source' | 'input' | 'mesh' | 'gltf'>;

type Packed = Pick<Unwrapped, 'result' | 'stacks' | 'isRepacked'>;

type Earlier = Pick<UnwrapOptions, 'known' | 'fixedCharts' | 'keepsPlaces' | 'seams' | 'seamEdges'>;

/**
 * What a run takes over: charts that stay the same are not flattened again, and locked ones stay
 * where they are. After an edit of seams, or when charts were moved, all that it leaves unchanged
 * stay where they are. Neither moving nor packing charts again cuts them.
 */
function fromEarlier(
  settings: UnwrapSettings,
  last: Unwrapped | null,
  hasOwnTiles: boolean,
): Earlier {
  const { kept, placed, fixedFaces } = settings;
  const given = placed === last?.settings.placed ? undefined : placed;
  const isEdit = last !== null && isSeamEdit(last.settings, settings);
  // Where new charts would go is not known to abflat if parts have tiles of their own.
  const keepsPlaces = given ? !given.repacks : isEdit && !hasOwnTiles;
  const layout = given ?? last?.result;
  const seams = given ? { seams: 'none', seamEdges: given.seams } : {};
  if (!kept || kept.charts.length === 0) {
    // Beside faces that stay, a chart is factored in another order, which changes its last digits.
    const isKnown = given || keepsPlaces || last?.settings.fixedFaces === fixedFaces;
    return { ...(isKnown && { known: layout }), keepsPlaces, ...seams };
  }
  // The numbers of locked charts are those of the layout in which they were locked.
  const isSame = keepsPlaces && (given !== undefined || kept.layout === last?.result);
  const known = isSame ? layout : kept.layout;
  const fixedCharts = kept.layout === last?.result ? lockedIn(last, settings) : kept.charts;
  return { known, fixedCharts, keepsPlaces: isSame, ...seams };
}

/** Locked charts: what abflat has stacked stays together, or of each stack one, if others are asked for. */
function lockedIn({ settings: before, stacks }: Unwrapped, { kept, stack }: UnwrapSettings) {
  const locked = kept?.charts ?? new Uint32Array();
  if (before.stack === 'none') return locked;
  const all = withStacks(locked, stacks);
  const upper = new Set(stacks?.flatMap(([, ...others]) => others));
  return stack === before.stack ? all : all.filter((chart) => !upper.has(chart));
}

/** Whether only seams have changed, and to listed ones: other sources may cut everything anew. */
const isSeamEdit = (before: UnwrapSettings, after: UnwrapSettings) =>
  after.seamEdges !== undefined &&
  (after.seamEdges !== before.seamEdges || after.seams !== before.seams) &&
  sameButSeams(before, after);

/** Those that have tiles of their own; null if there are not several. */
async function partsWithTiles(
  opened: Pick<Opened, 'source' | 'mesh' | 'gltf'>,
  tiles: UnwrapSettings['tiles'],
  helpers: Pick<Helpers, 'namedParts'>,
): Promise<readonly NamedPart[] | null> {
  if (!tiles) return null;
  const { objects, materials } = await helpers.namedParts(opened);
  const parts = tiles === 'object' ? objects : materials;
  return parts.filter(({ isThere }) => isThere).length > 1 ? parts : null;
}

/** Charts that are still to be packed in tiles fit in one at first; others may be in any. */
const forOwnTiles = ({ keepsPlaces }: UnwrapOptions): UnwrapOptions =>
  keepsPlaces ? { udim: true, texelDensity: 1 } : { udim: false, texelDensity: 'auto' };

/**
 * One run of abflat with these settings. `earlier`: the last outcome, of any mesh; `format`: that of
 * the file to write.
 */
export async function layOut(
  abflat: Abflat,
  { source, input, mesh, gltf }: Input,
  settings: FlattenSettings | UnwrapSettings,
  earlier: Outcome | null,
  watch: Watch,
  helpers: StackHelpers & Pick<Helpers, 'namedParts'>,
  format: ExportFormat = exportFormatOf(source.name),
): Promise<Flattened | Unwrapped> {
  const roundsForGltf = exportFormatOf(source.name) === 'glb';
  const file = format === 'glb' ? {} : { [format]: true };
  if (settings.mode === 'flatten') {
    const { mode, ...options } = settings;
    const result = await abflat.flatten(await copied(input), {
      ...options,
      ...file,
      // In the unit of the mesh, a texture would repeat as often as the mesh is large.
      normalize: true,
      transfer: true,
      roundsForGltf,
      ...watch,
    });
    return { mode, source, mesh, gltf, settings, result };
  }
  const { mode, kept, placed, pins, tiles, ...options } = settings;
  const parts = await partsWithTiles({ source, mesh, gltf }, tiles, helpers);
  const unwrap = async (known: UnwrapOptions) =>
    abflat.unwrap(await copied(input), {
      ...options,
      ...(parts && forOwnTiles(known)),
      ...known,
      ...file,
      keepsValidOnly: true,
      transfer: true,
      roundsForGltf,
      ...watch,
    });
  const last = earlier?.mode === 'unwrap' && earlier.source === source ? earlier : null;
  const known = fromEarlier(settings, last, parts !== null);
  const made = ({ stacks, ...rest }: Packed): Unwrapped => {
    const isAsBefore = last?.settings.stack === settings.stack;
    const unstacked = isAsBefore ? stackedCharts(last?.stacks) - stackedCharts(stacks) : 0;
    return { mode, source, mesh, gltf, settings, ...rest, stacks, unstacked };
  };
  const runs = { abflat, input, helpers, signal: watch.signal };
  const packed = async (known: Earlier): Promise<Packed> => {
    const { faceDensities, fixedFaces } = settings;
    const isByHand = settings.stack === 'none' && last?.settings.stack === 'none';
    // Charts that take the uv of the file leave their stacks.
    if (!isByHand || !last?.stacks || fixedFaces !== last.settings.fixedFaces) {
      const result = await unwrap(known);
      return { result, stacks: stacksIn(result.report) };
    }
    const { keepingStacks } = await stackParts();
    return keepingStacks(last, last.stacks, { ...known, faceDensities }, unwrap, runs);
  };
  const inTiles = async (known: Earlier): Promise<Packed> => {
    const all = await packed(known);
    if (!parts) return all;
    const { inPartTiles } = await loadPart(import('./part-tiles'));
    const before = last && isSeamEdit(last.settings, settings) ? last.result : null;
    return inPartTiles(all, parts, { settings, mesh, before }, runs);
  };
  if (!known.keepsPlaces) return made(await inTiles(known));
  const repacked = async () =>
    made({ ...(await inTiles({ ...known, keepsPlaces: false })), isRepacked: true });
  const inPlace = async () => {
    const [{ judged }, result] = await Promise.all([stackParts(), unwrap(known)]);
    return made(await judged(result, runs));
  };
  // Beside the charts that stay there may be no room for the others at the density asked for.
  const outcome = (await unlessTooSmall(inPlace)) ?? (await repacked());
  // What was not valid before is not to be put right unasked.
  const mayRepack = placed?.mayRepack && last?.result.report.valid;
  const { report } = outcome.result;
  if (!mayRepack || report.valid || !isMisplaced(report)) return outcome;
  return (await unlessTooSmall(repacked)) ?? outcome;
}

/** Null if the charts do not fit. */
async function unlessTooSmall<T>(work: () => Promise<T>): Promise<T | null> {
  try {
    return await work();
  } catch (error) {
    if ((error as AbflatError).code === 'AtlasTooSmall') return null;
    throw error;
  }
}
