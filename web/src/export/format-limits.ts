import '../css/format-limits.css';
import { create, element } from '../base/dom';
import { exportFormatOf, meshFileOf } from '../base/mesh-files';
import type { Outcome } from '../model/model';
import { EXPORT_FORMATS, type ExportFormat } from '../words/generated-formats';
import { LIMITS } from '../words/limits';

/** Says in the menu of exports what a file loses in formats other than its own. */
export function showLimits(outcome: Outcome | null): void {
  const menu = element('export-menu', HTMLElement);
  for (const format of EXPORT_FORMATS) {
    const item = menu.querySelector(`[data-value="${format}"]`);
    item?.querySelector('small')?.remove();
    const limit = outcome && limitOf(outcome, format);
    if (limit) item?.append(' ', create('small', 'format-limit', limit));
  }
}

/** '' if there is nothing to lose. */
export function limitOf({ source, gltf }: Outcome, format: ExportFormat): string {
  const { name } = source;
  if (!meshFileOf(name)?.exported || exportFormatOf(name) === format) return '';
  return gltf && gltf.holds.length > 0 ? LIMITS.loses(gltf.holds) : LIMITS.shapeOnly;
}
