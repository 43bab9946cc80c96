import { element } from '../base/dom';
import { loadPart, reasonOf } from '../base/load-part';

export const helpParts = () => loadPart(import('./help-groups'));

/** The sheet with all keys. */
export class HelpSheet {
  private readonly sheet = element('help-sheet', HTMLDialogElement);
  private readonly groups = element('help-groups', HTMLElement);

  constructor() {
    element('help', HTMLButtonElement).addEventListener('click', () => this.open());
    element('help-close', HTMLButtonElement).addEventListener('click', () => this.sheet.close());
    this.sheet.addEventListener('click', ({ target }) => {
      // What is beside the sheet is the sheet's backdrop.
      if (target === this.sheet) this.sheet.close();
    });
    // No key reaches the page behind it.
    this.sheet.addEventListener('keydown', (event) => event.stopPropagation());
  }

  open(): void {
    if (!this.sheet.open) this.sheet.showModal();
    helpParts().then(
      ({ helpGroups }) => {
        if (this.isEmpty) this.groups.replaceChildren(...helpGroups());
      },
      (error: Error) => {
        if (this.isEmpty) this.groups.textContent = reasonOf(error);
      },
    );
  }

  /** Without the groups; it may say why. */
  private get isEmpty(): boolean {
    return this.groups.childElementCount === 0;
  }
}
