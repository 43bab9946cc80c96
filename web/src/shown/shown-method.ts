import type { Comparison, MethodResult } from 'abflat';
import { element, showText } from '../base/dom';
import type { MetricsPanel } from '../details/metrics';
import type { Outcome } from '../model/model';
import type { Views } from '../view/views';
import { METRICS } from '../words/result';
import { SHOWN } from '../words/view';
import type { Workshop } from '../workshop/workshop';
import { ownerOf } from './stale-mark';

/** The layout of another method, shown in place of the result, which is still what gets exported. */
export class ShownMethod {
  private readonly note = element('method-note', HTMLElement);
  private method: MethodResult | null = null;

  constructor(
    private readonly workshop: Workshop,
    private readonly metrics: MetricsPanel,
    private readonly views: Views | null,
  ) {}

  /** Does nothing if something else was shown before the layout could be drawn. */
  async show(
    method: MethodResult,
    comparison: Comparison,
    outcome: Outcome,
    isStill: () => boolean,
  ): Promise<void> {
    this.method = method;
    const layout = { ...comparison, uv: method.uv };
    const drawing = await this.workshop.layout(layout, outcome.mesh, null);
    if (this.method !== method || !isStill()) return;
    this.note.hidden = false;
    this.metrics.mark({ text: METRICS.ofResult, owner: ownerOf(outcome) });
    this.views?.showFlat(drawing, { ...method, bounds: [], delaunay: null });
    showText(element('layout-info', HTMLElement), method.title);
    element('method-note-text', HTMLElement).textContent = SHOWN.comparison(method.title);
  }

  /** The result is shown again. */
  hide(): void {
    this.method = null;
    this.note.hidden = true;
    this.metrics.mark(null);
  }
}
