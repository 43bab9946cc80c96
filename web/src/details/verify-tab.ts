import '../css/verify.css';
import { create, element } from '../base/dom';
import { download } from '../base/download';
import type { FlatDrawing } from '../model/drawing';
import type { Outcome } from '../model/model';
import { Job } from '../session/job';
import type { Session } from '../session/session';
import { type Verifiable, type Verified, verifyLayout } from '../session/verify-layout';
import { FaceMarks } from '../view/face-marks';
import type { Views } from '../view/views';
import { TAB_JOBS } from '../words/details';
import { VERIFY } from '../words/verify';
import { FindingList } from './finding-list';
import { VerifyRules } from './verify-rules';

export interface VerifyEvents {
  /** What selects islands; undefined if nothing is drawn. */
  selection(): { selection: { pickSome(islands: number[]): void } } | undefined;
  say(text: string): void;
}

/** What the layout on screen does not keep to. */
export class VerifyTab {
  private readonly button = create('button', 'button', VERIFY.start);
  private readonly save = create('button', 'button', VERIFY.save);
  private readonly text = create('p', 'verify-verdict');
  private readonly rules: VerifyRules;
  private readonly list: FindingList;
  private readonly job = new Job((isRunning) => {
    this.button.textContent = isRunning ? TAB_JOBS.stop : VERIFY.start;
  });
  private readonly marks: FaceMarks | null;
  private outcome: Verifiable | null = null;
  private drawing: FlatDrawing | null = null;
  private verified: Verified | null = null;
  /** Those of the finding that is shown in the views. */
  private marked: ReadonlySet<number> | null = null;

  constructor(
    private readonly session: Session,
    private readonly views: Views | null,
    private readonly events: VerifyEvents,
  ) {
    this.marks = views && new FaceMarks(views.surfaces);
    this.rules = new VerifyRules(() => this.asked(), events.say);
    this.list = new FindingList((finding) => this.mark(finding));
    this.text.role = 'status';
    this.save.title = VERIFY.aboutSave;
    for (const button of [this.button, this.save]) button.type = 'button';
    this.button.id = 'verify';
    this.save.id = 'verify-save';
    this.button.addEventListener('click', () => {
      if (!this.stop()) void this.run();
    });
    this.save.addEventListener('click', () => this.saveReport());
    const row = create('div', 'panel-row');
    row.append(this.button, this.save);
    const about = create('p', '', VERIFY.about);
    element('panel-verify', HTMLElement).append(
      about,
      this.rules.element,
      row,
      this.text,
      this.list.element,
    );
    this.update();
  }

  /** Null: the mesh on screen has no layout yet. */
  show(last: { outcome: Outcome; drawing: FlatDrawing } | null): void {
    const { outcome = null, drawing = null } = last ?? {};
    const shown = outcome?.mode === 'flatten' ? null : outcome;
    this.drawing = drawing;
    if (shown === this.outcome) return;
    this.outcome = shown;
    this.job.stop();
    this.clear('');
    if (shown) this.rules.offer(texelsOf(shown));
  }

  /** Returns whether there was anything to stop. */
  stop(): boolean {
    if (!this.job.isRunning) return false;
    this.job.stop();
    this.tell(TAB_JOBS.stopped, '');
    return true;
  }

  /** Once other islands are selected, no finding is shown any more. */
  showSelected(selected: ReadonlySet<number>): void {
    const { marked } = this;
    if (!marked) return;
    const isShown = [...selected].every((island) => marked.has(island));
    if (isShown && (selected.size > 0 || marked.size === 0)) return;
    this.list.leave();
    this.unmark();
  }

  private clear(text: string): void {
    this.verified = null;
    this.list.clear();
    this.unmark();
    this.tell(text, '');
    this.update();
  }

  /** Another rule: what was found before is judged again. */
  private asked(): void {
    if (this.verified || this.job.isRunning) void this.run();
  }

  private async run(): Promise<void> {
    const { outcome } = this;
    if (!outcome) {
      this.tell(VERIFY.noLayout, '');
      return;
    }
    this.clear(TAB_JOBS.starting);
    try {
      await this.job.start(async (signal) => {
        const found = await this.verify(outcome, signal);
        signal.throwIfAborted();
        this.found(found);
      });
    } catch (error) {
      this.tell(error instanceof Error ? error.message : String(error), 'bad');
    }
  }

  private verify(outcome: Verifiable, signal: AbortSignal): Promise<Verified> {
    const onProgress = ({ fraction }: { fraction: number }) => {
      if (!signal.aborted) this.tell(VERIFY.progress(fraction), '');
    };
    const { options } = this.rules;
    return this.session.aside(
      (abflat, input, signal) =>
        verifyLayout(abflat, input, outcome, options, { signal, onProgress }),
      signal,
    );
  }

  private found(verified: Verified): void {
    this.verified = verified;
    const { valid, islands, findings } = verified.report;
    this.tell(
      valid ? VERIFY.valid(islands) : VERIFY.found(findings.length),
      valid ? 'good' : 'bad',
    );
    this.list.show(verified);
    this.update();
  }

  private tell(text: string, verdict: 'good' | 'bad' | ''): void {
    this.text.textContent = text;
    this.text.dataset.verdict = verdict;
  }

  private update(): void {
    this.save.disabled = this.verified === null;
  }

  private mark(finding: number | null): void {
    const none = { islands: [], triangles: [] };
    const marks = finding === null ? none : (this.verified?.marks[finding] ?? none);
    this.marked = finding === null ? null : new Set(marks.islands);
    this.marks?.show(this.drawing, marks.triangles);
    this.events.selection()?.selection.pickSome(marks.islands);
    if (marks.islands.length > 0) this.views?.goToCharts(marks.islands);
  }

  private unmark(): void {
    if (!this.marked) return;
    this.marked = null;
    this.marks?.show(null, []);
  }

  private saveReport(): void {
    const { outcome, verified } = this;
    if (!outcome || !verified) return;
    const name = VERIFY.fileName(outcome.source.name);
    download(name, 'application/json', `${JSON.stringify(verified.report, null, 2)}\n`);
    this.events.say(VERIFY.saved(name));
  }
}

/** Along a side of the texture. */
function texelsOf(outcome: Verifiable): number {
  return outcome.mode === 'pack'
    ? outcome.result.report.resolution
    : outcome.result.report.atlas.resolution;
}
