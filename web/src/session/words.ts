import { FLATTEN_DEFAULTS, type MeshSummary, UNWRAP_DEFAULTS } from 'abflat';
import type { DisplayMesh } from '../mesh/mesh';
import { foundChart } from '../model/found-chart';
import type { Flattened, Outcome, Source, Unwrapped } from '../model/model';
import { changedOptions } from '../model/more-options';
import { type PackSettings, type Settings, usualPackChoices } from '../model/settings';
import { ended, inPageWords } from '../words/format';
import { READING } from '../words/opening';
import { ISLANDS } from '../words/result';
import { LAYING_OUT, LOOKING_AT_UVS, RUN, SETTINGS } from '../words/run';
import { PACKING } from '../words/selection';
import { SHOWN } from '../words/view';
import { inRoomWords } from './no-room';
import { titleOf } from './titles';

/** "t = auto, Delaunay" */
export function settingsText(settings: Settings): string {
  if (settings.mode === 'unwrap') {
    const { maxStretch, resolution, padding, seams, seamEdges } = settings;
    const along = seamEdges ? SETTINGS.seamEdges(seamEdges.length / 2) : SETTINGS.seams(seams);
    const size = SETTINGS.size(resolution, padding);
    const lengths = balanceText(settings.balance, UNWRAP_DEFAULTS.balance);
    const rest = [...lengths, size, ...changedOptions(settings)];
    return [along, SETTINGS.stretch(maxStretch), ...rest].join(', ');
  }
  if (settings.mode === 'pack') return packText(settings);
  const delaunay = settings.delaunay ? [SETTINGS.delaunay] : [];
  const lengths = balanceText(settings.balance, FLATTEN_DEFAULTS.balance);
  const count = settings.bounds?.length ?? 0;
  const own = count > 0 ? [SETTINGS.ownBounds(count)] : [];
  return [SETTINGS.t(settings.t), ...own, ...lengths, ...delaunay].join(', ');
}

function packText({ keepPlaces, resolution, uv, ...choices }: PackSettings): string {
  if (keepPlaces) return uv ? SETTINGS.changedUvs : SETTINGS.uvsOfFile;
  const { padding, margin, rotate, islandSizes, tiles } = { ...usualPackChoices(), ...choices };
  return [
    SETTINGS.size(resolution, padding),
    SETTINGS.margin(margin),
    SETTINGS.rotation(rotate),
    SETTINGS.sizes(islandSizes),
    ...(tiles === 'one' ? [] : [SETTINGS.tiles(PACKING.tiles[tiles])]),
  ].join(', ');
}

/** What is done to a mesh, in words. */
export const layingOut = (settings: Settings) =>
  settings.mode === 'pack' && settings.keepPlaces ? LOOKING_AT_UVS : LAYING_OUT[settings.mode];

const balanceText = (balance: number, usual: number) =>
  balance === usual ? [] : [SETTINGS.balance(balance)];

/** "500 polygons, 968 triangles"; for a triangle mesh just the number of triangles. */
export function facesText({ indices }: DisplayMesh, { faces }: MeshSummary): string {
  const triangles = indices.length / 3;
  return faces === triangles ? SHOWN.triangles(triangles) : SHOWN.polygons(faces, triangles);
}

/** Files of programs that can export glTF. */
const SCENE = /\.(blend|dae|3ds|max|m[ab]|c4d|lwo|abc|usd[acz]?)$/i;

/** What to do with a file in a format that is not read. */
export const notSupported = (name: string): string =>
  SCENE.test(name) ? READING.scene(name) : READING.notSupported(name);

/** What went wrong as a sentence that names the mesh. */
export function failure(source: Source, settings: Settings | null, message: string): string {
  const text = inPageWords(inRoomWords(message));
  if (text.includes(source.name)) return ended(text);
  return RUN.failed(titleOf(source), settings && layingOut(settings).done, text);
}

/**
 * The charts of an atlas and what they look like, or the t of a layout with the value that the
 * automatic choice found.
 */
export function layoutInfo(outcome: Outcome): string {
  if (outcome.mode === 'flatten') return boundInfo(outcome);
  if (outcome.mode === 'pack') {
    const { islands, tiles } = outcome.result.report;
    return ISLANDS.info(islands, tiles);
  }
  const { charts, atlas } = outcome.result.report;
  const found = foundText(outcome.result.report);
  return SHOWN.charts(charts.length, atlas.tiles) + (found ? `: ${found}` : '');
}

/** "3 strips, 2 discs, symmetric" */
function foundText({ charts, seams, atlas }: Unwrapped['result']['report']): string {
  const shapes = Object.entries(SHOWN.shapes).flatMap(([shape, named]) => {
    const several = charts.filter((chart) => chart.shape === shape).length;
    return several > 0 ? [named(several)] : [];
  });
  const symmetric = seams.symmetric ? [SHOWN.symmetric] : [];
  const cuts = atlas.packingCuts > 0 ? [SHOWN.packingCuts(atlas.packingCuts)] : [];
  return [...shapes, ...symmetric, ...cuts].join(', ');
}

function boundInfo(outcome: Flattened): string {
  const { t } = outcome.settings;
  if (t !== 'auto') return SHOWN.t(t);
  const chart = foundChart(outcome);
  return SHOWN.automaticT(chart.t >= 2 ? null : chart.t, chart.bounds.length);
}

/** Whether charts were moved and nothing was laid out. */
export const isOnlyPlaced = ({ mode, settings, result }: Outcome): boolean =>
  mode === 'pack'
    ? settings.keepPlaces && settings.uv !== undefined
    : mode === 'unwrap' && 'placed' in settings && result.report.charts.every(({ fixed }) => fixed);

/** Whether the charts that were there were packed again. */
export const isPackedAgain = ({ mode, settings }: Outcome): boolean =>
  mode === 'unwrap' && Boolean(settings.placed?.repacks || settings.placed?.mayRepack);

/**
 * For a disk: the vertices with a bound of their own. For an edited atlas: the charts that the edit leaves as and where they were, those
 * that were to stay, and those that have lost their stack.
 */
export function kept(outcome: Outcome): string {
  if (outcome.mode === 'flatten') {
    const own = outcome.settings.bounds?.length ?? 0;
    return own > 0 ? RUN.ownBounds(own) : '';
  }
  if (outcome.mode === 'pack') return '';
  const { unstacked = 0 } = outcome;
  return keptCharts(outcome) + (unstacked > 0 ? RUN.unstacked(unstacked) : '');
}

function keptCharts(outcome: Unwrapped): string {
  if (outcome.isRepacked) return RUN.repacked;
  const { charts } = outcome.result.report;
  const known = charts.filter(({ solver, fixed }) => solver === 'known' && fixed).length;
  const fixed = charts.filter(({ solver }) => solver === 'given').length;
  const fixedAs = outcome.settings.fixedFaces ? RUN.keptAsInFile : RUN.locked;
  if (known > 0 && fixed > 0) return RUN.keptAndFixed(known, fixed, fixedAs);
  const [number, what] = known > 0 ? [known, RUN.kept] : [fixed, fixedAs];
  return number > 0 ? RUN.someCharts(number, charts.length, what) : '';
}
