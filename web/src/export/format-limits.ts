import '../css/format-limits.css';
import { create, element } from '../base/dom';
import { exportFormatOf, meshFileOf } from '../base/mesh-files';
import type { Outcome } from '../model/model';
import { EXPORT_FORMATS, type ExportFormat } from '../words/generated-formats';
import { LIMITS } from '../words/limits';

/** Says in the menu of exports what a file loses in formats other than its own; those that get new textures lose less. */
export function showLimits(outcome: Outcome | null, baked: ExportFormat[] = []): void {
  const menu = element('export-menu', HTMLElement);
  for (const format of EXPORT_FORMATS) {
    const item = menu.querySelector(`[data-value="${format}"]`);
    item?.querySelector('small')?.remove();
    const limit = outcome && limitOf(outcome, format, baked);
    if (limit) item?.append(' ', create('small', 'format-limit', limit));
  }
}

/** '' if there is nothing to lose. `baked`: the formats that get new textures. */
export function limitOf(
  { source, gltf }: Outcome,
  format: ExportFormat,
  baked: ExportFormat[] = [],
): string {
  const { name } = source;
  const { lost = [], holds = [] } = gltf ?? {};
  if (!meshFileOf(name)?.exported) return '';
  if (exportFormatOf(name) === format) return LIMITS.loses(lost);
  // No other format has a place for what else is lost.
  const all = [...lost.filter((each) => each === 'polygons'), ...holds];
  if (baked.includes(format)) return LIMITS.loses(all.filter((each) => each !== 'materials'));
  if (baked.length > 0) return LIMITS.notBaked;
  return LIMITS.loses(all) || LIMITS.shapeOnly;
}
