import { bound, counted } from './format';
import { titleOf } from './open-mesh';
import type { Outcome, Settings, Source } from './session';

/** "t = auto, Delaunay" */
export function settingsText({ t, delaunay }: Settings): string {
  return `t = ${bound(t)}${delaunay ? ', Delaunay' : ''}`;
}

/** What went wrong as a sentence that names the mesh. */
export function failure(source: Source, settings: Settings | null, message: string): string {
  const text = message.replace(/\.$/, '');
  if (text.includes(source.name)) return `${text}.`;
  const what = settings === null ? 'was not opened' : 'was not flattened';
  return `${titleOf(source)} ${what}: ${text}.`;
}

/** The t of a layout, and what the automatic choice came to. */
export function layoutInfo({ settings, result }: Outcome): string {
  if (settings.t !== 'auto') return `t = ${bound(settings.t)}`;
  const [chart] = result.report.charts;
  const tightened = chart.bounds.length;
  const but = tightened > 0 ? ` but for ${counted(tightened, 'vertex', 'vertices')}` : '';
  return `t = auto: ${chart.t >= 2 ? 'free' : bound(chart.t)}${but}`;
}
