import { element } from '../base/dom';
import type { MetricsPanel } from '../details/metrics';
import type { Outcome, Source } from '../model/model';
import { type Settings, sameSettings } from '../model/settings';
import { titleOf } from '../session/titles';
import { settingsText } from '../session/words';
import { METRICS } from '../words/result';
import { SHOWN } from '../words/view';

/** Names the mesh and settings that a result belongs to, for display. */
export const ownerOf = ({ source, settings }: Outcome) =>
  SHOWN.owner(titleOf(source), settingsText(settings));

/** Says on layout and numbers that they belong to earlier settings, or that there are none. */
export class StaleMark {
  private readonly note = element('layout-note', HTMLElement);
  private readonly stage = element('layout-stage', HTMLElement);

  constructor(private readonly metrics: MetricsPanel) {}

  /**
   * `shown` is the mesh on screen and `outcome` its last one; `settings` are those asked for. Returns
   * whether the outcome is of others.
   */
  show(outcome: Outcome | null, shown: Source | null, settings: Settings): boolean {
    const isStale = outcome !== null && !sameSettings(outcome.settings, settings);
    const owner = isStale ? ownerOf(outcome) : '';
    this.note.textContent = outcome ? SHOWN.previous : SHOWN.noLayout;
    this.note.title = owner;
    this.note.hidden = outcome ? !isStale : shown === null;
    this.stage.classList.toggle('stale', isStale);
    this.metrics.mark(isStale ? { text: METRICS.previous, owner } : null);
    return isStale;
  }
}
