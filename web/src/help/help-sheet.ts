import { create, element } from '../base/dom';
import { KEY_NAMES } from '../words/help';
import { CONTROLS, type Control, type ControlGroup } from './keys';

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
    if (this.groups.childElementCount === 0) this.groups.append(...CONTROLS.map(section));
    if (!this.sheet.open) this.sheet.showModal();
  }
}

function section({ title, where, controls }: ControlGroup): HTMLElement {
  const made = create('section', 'help-group');
  const list = create('dl', 'help-list');
  for (const control of controls) list.append(row(control));
  made.append(create('h3', '', title), ...(where ? [create('p', 'help-where', where)] : []), list);
  return made;
}

function row({ keys, gestures, does }: Control): HTMLElement {
  const made = create('div', 'help-row');
  const how = create('dt', '');
  for (const key of keys) how.append(keyOf(key));
  if (gestures) how.append(create('span', 'help-gestures', gestures));
  made.append(how, create('dd', '', does));
  return made;
}

/** "Ctrl+Z": its parts as on the keyboard; + alone is a key. */
function keyOf(key: string): HTMLElement {
  const parts = key === '+' ? [key] : key.split('+');
  return create('kbd', '', parts.map((part) => KEY_NAMES[part] ?? part).join(' '));
}
