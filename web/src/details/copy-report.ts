import { hideAlert, showAlert } from '../base/alert';
import { element } from '../base/dom';
import type { Outcome } from '../model/model';
import { REPORT } from '../words/details';

/** The button that copies all numbers of a result. */
export class CopyReport {
  private readonly button = element('copy-report', HTMLButtonElement);
  private outcome: Outcome | null = null;

  constructor(private readonly say: (text: string) => void) {
    this.button.addEventListener('click', () => void this.copy());
  }

  show(outcome: Outcome): void {
    this.outcome = outcome;
    this.button.disabled = false;
  }

  clear(): void {
    this.outcome = null;
    this.button.disabled = true;
  }

  private async copy(): Promise<void> {
    if (!this.outcome) return;
    try {
      await navigator.clipboard.writeText(JSON.stringify(this.outcome.result.report, null, 2));
      hideAlert();
      this.say(REPORT.copied);
    } catch (error) {
      console.info('The clipboard cannot be written:', error);
      showAlert(REPORT.notCopied, REPORT.allow);
    }
  }
}
