// Asks before anything is fetched from another server.

import { WEB_SHEET } from '../base/english';
import '../css/web-sheet.css';
import { create } from '../base/dom';
import { type Address, shown } from './address';

export interface Question {
  title: string;
  paragraphs: string[];
  /** On the button that agrees. */
  yes: string;
}

/** Resolves when a button was pressed, or Escape. */
export function ask({ title, paragraphs, yes }: Question): Promise<boolean> {
  const sheet = create('dialog', 'sheet question');
  const heading = create('h2', 'question-title', title);
  heading.id = 'question-title';
  sheet.setAttribute('aria-labelledby', heading.id);
  const form = create('form', 'question-page');
  form.method = 'dialog';
  const buttons = create('div', 'question-buttons');
  const [no, agree] = [answer(WEB_SHEET.cancel, ''), answer(yes, 'yes')];
  agree.classList.add('primary');
  agree.autofocus = true;
  buttons.append(no, agree);
  form.append(heading, ...paragraphs.map((text) => create('p', '', text)), buttons);
  sheet.append(form);
  // No key reaches the page behind it.
  sheet.addEventListener('keydown', (event) => event.stopPropagation());
  document.body.append(sheet);
  sheet.showModal();
  return new Promise((resolve) => {
    sheet.addEventListener('close', () => {
      sheet.remove();
      resolve(sheet.returnValue === 'yes');
    });
  });
}

function answer(text: string, value: string): HTMLButtonElement {
  const button = create('button', 'button', text);
  button.value = value;
  return button;
}

/** Before the first request. `bytes`: the size, if it is known. */
export function openFrom({ url, name, host }: Address, bytes: number | null): Question {
  const size = bytes === null ? '' : megabytes(bytes);
  const namesFiles = /\.(gltf|obj)$/i.test(name);
  return {
    title: WEB_SHEET.openFrom(name, host),
    paragraphs: [WEB_SHEET.whatHappens(host, size, namesFiles), shown(url)],
    yes: WEB_SHEET.open,
  };
}

export const fetchLarge = (name: string, bytes: number): Question => ({
  title: WEB_SHEET.fetchLarge(megabytes(bytes)),
  paragraphs: [WEB_SHEET.large(name, megabytes(bytes))],
  yes: WEB_SHEET.fetch,
});

/** "0.3 MB", "12 MB". */
export function megabytes(bytes: number): string {
  const size = bytes / 1e6;
  return WEB_SHEET.megabytes(size < 9.95 ? Math.max(0.1, size).toFixed(1) : size.toFixed(0));
}
