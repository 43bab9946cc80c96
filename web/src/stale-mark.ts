import { element } from './base/dom';
import { SHOWN } from './base/english';
import type { MetricsPanel } from './details/metrics';
import type { Outcome, Source } from './model/model';
import { type Settings, sameSettings } from './model/settings';
import { titleOf } from './session/titles';
import { settingsText } from './session/words';

/** Names the mesh and settings that a result belongs to, for display. */
export const ownerOf = ({ source, settings }: Outcome) =>
  SHOWN.owner(titleOf(source), settingsText(settings));

/** Says on layout and numbers that they belong to an earlier mesh or earlier settings. */
export class StaleMark {
  private readonly note = element('layout-note', HTMLElement);
  private readonly stage = element('layout-stage', HTMLElement);

  constructor(private readonly metrics: MetricsPanel) {}

  /**
   * `shown` is the mesh on screen, `settings` are those asked for. Returns whether the outcome is of
   * others.
   */
  show(outcome: Outcome | null, shown: Source | null, settings: Settings): boolean {
    const stale =
      outcome && (outcome.source !== shown || !sameSettings(outcome.settings, settings))
        ? ownerOf(outcome)
        : null;
    this.note.textContent = SHOWN.previous;
    this.note.title = stale ?? '';
    this.note.hidden = stale === null;
    this.stage.classList.toggle('stale', stale !== null);
    this.metrics.markStale(stale);
    return stale !== null;
  }
}
