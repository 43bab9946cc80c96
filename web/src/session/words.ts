import { FLATTEN_DEFAULTS, type MeshSummary, UNWRAP_DEFAULTS } from 'abflat';
import { bound, count, counted, inPageWords } from '../base/format';
import type { DisplayMesh } from '../mesh/mesh';
import { foundChart } from '../model/found-chart';
import type { Flattened, Outcome, Source } from '../model/model';
import { changedOptions } from '../model/more-options';
import type { Mode, Settings } from '../model/settings';
import { titleOf } from './titles';

interface Words {
  doing: string;
  done: string;
  /** On a button. */
  verb: string;
}

export const WORDS: Record<Mode, Words> = {
  flatten: { doing: 'Flattening', done: 'Flattened', verb: 'Flatten' },
  unwrap: { doing: 'Unwrapping', done: 'Unwrapped', verb: 'Unwrap' },
};

/** "t = auto, Delaunay" */
export function settingsText(settings: Settings): string {
  if (settings.mode === 'unwrap') {
    const { maxStretch, resolution, padding, seams, seamEdges } = settings;
    const along = seamEdges ? `${counted(seamEdges.length / 2, 'seam edge')}` : `seams ${seams}`;
    const size = `${resolution}\u202fpx, padding ${padding}`;
    const lengths = balanceText(settings.balance, UNWRAP_DEFAULTS.balance);
    const rest = [...lengths, size, ...changedOptions(settings)];
    return [along, `stretch up to ${maxStretch}`, ...rest].join(', ');
  }
  const delaunay = settings.delaunay ? ['Delaunay'] : [];
  const lengths = balanceText(settings.balance, FLATTEN_DEFAULTS.balance);
  const count = settings.bounds?.length ?? 0;
  const own = count > 0 ? [`own bounds of ${counted(count, 'vertex', 'vertices')}`] : [];
  return [`t = ${bound(settings.t)}`, ...own, ...lengths, ...delaunay].join(', ');
}

const balanceText = (balance: number, usual: number) =>
  balance === usual ? [] : [`balance ${balance}`];

/** "500 polygons, 968 triangles"; for a triangle mesh just the number of triangles. */
export function facesText({ indices }: DisplayMesh, { faces }: MeshSummary): string {
  const triangles = counted(indices.length / 3, 'triangle');
  return faces === indices.length / 3 ? triangles : `${counted(faces, 'polygon')}, ${triangles}`;
}

/** What went wrong as a sentence that names the mesh. */
export function failure(source: Source, settings: Settings | null, message: string): string {
  const text = inPageWords(message).replace(/\.$/, '');
  if (text.includes(source.name)) return `${text}.`;
  const what = settings === null ? 'opened' : WORDS[settings.mode].done.toLowerCase();
  return `${titleOf(source)} was not ${what}: ${text}.`;
}

/**
 * The number of charts of an atlas, or the t of a layout with the value that the automatic choice
 * found.
 */
export function layoutInfo(outcome: Outcome): string {
  if (outcome.mode === 'flatten') return boundInfo(outcome);
  const { charts, atlas } = outcome.result.report;
  const tiles = atlas.tiles > 1 ? `, ${counted(atlas.tiles, 'tile')}` : '';
  return counted(charts.length, 'chart') + tiles;
}

function boundInfo(outcome: Flattened): string {
  const { t } = outcome.settings;
  if (t !== 'auto') return `t = ${bound(t)}`;
  const chart = foundChart(outcome);
  const tightened = chart.bounds.length;
  const but = tightened > 0 ? ` except at ${counted(tightened, 'vertex', 'vertices')}` : '';
  return `t = auto: ${chart.t >= 2 ? 'free' : bound(chart.t)}${but}`;
}

/** Whether charts were moved and nothing was laid out. */
export const isOnlyPlaced = ({ mode, settings, result }: Outcome): boolean =>
  mode === 'unwrap' && 'placed' in settings && result.report.charts.every(({ fixed }) => fixed);

/**
 * For a disk: the vertices with a bound of their own. For an edited atlas: the charts that did not change and those that were to stay where they are.
 */
export function kept(outcome: Outcome): string {
  if (outcome.mode === 'flatten') {
    const own = outcome.settings.bounds?.length ?? 0;
    return own > 0 ? `; ${counted(own, 'own bound')}` : '';
  }
  if (outcome.isRepacked) return '; packed again, as there was too little room';
  const { charts } = outcome.result.report;
  const known = charts.filter(({ solver }) => solver === 'known').length;
  const fixed = charts.filter(({ solver }) => solver === 'given').length;
  const fixedAs = outcome.settings.fixedFaces ? 'as in the file' : 'locked';
  if (known > 0 && fixed > 0) return `; ${count(known)} kept, ${count(fixed)} ${fixedAs}`;
  const [number, what] = known > 0 ? [known, 'kept'] : [fixed, fixedAs];
  return number > 0 ? `; ${count(number)} of ${counted(charts.length, 'chart')} ${what}` : '';
}
