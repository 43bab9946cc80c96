import { create } from '../base/dom';
import type { Verified } from '../session/verify-layout';
import { FINDING, VERIFY } from '../words/verify';

/** Nobody reads more rows, and they would be slow. */
const MOST_ROWS = 200;

/** What a layout does not keep to, a button each. */
export class FindingList {
  readonly element = create('ul', 'findings');
  private buttons: HTMLButtonElement[] = [];

  /** `chosen` is called with the number of a finding; null: none any more. */
  constructor(private readonly chosen: (finding: number | null) => void) {
    this.element.ariaLabel = VERIFY.list;
  }

  show({ report, marks }: Verified): void {
    const shown = report.findings.slice(0, MOST_ROWS);
    this.buttons = shown.map((found, i) => {
      const button = create('button', 'finding');
      button.type = 'button';
      button.ariaPressed = 'false';
      const name = create('span', 'finding-name', FINDING.name(found));
      const detail = create('span', '', FINDING.detail(found, marks[i].islands));
      button.append(name, detail, create('span', 'finding-help', FINDING.help(found)));
      button.addEventListener('click', () => this.choose(i));
      return button;
    });
    const rows = this.buttons.map((button) => {
      const row = create('li', '');
      row.append(button);
      return row;
    });
    const left = report.findings.length - shown.length;
    if (left > 0) rows.push(create('li', 'panel-text', VERIFY.more(left)));
    this.element.replaceChildren(...rows);
  }

  clear(): void {
    this.buttons = [];
    this.element.replaceChildren();
  }

  /** Nothing is chosen any more. */
  leave(): void {
    for (const button of this.buttons) button.ariaPressed = 'false';
  }

  private choose(finding: number): void {
    const isChosen = this.buttons[finding].ariaPressed === 'true';
    this.leave();
    this.buttons[finding].ariaPressed = String(!isChosen);
    this.chosen(isChosen ? null : finding);
  }
}
