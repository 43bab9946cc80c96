import '../css/question.css';
import { create } from '../base/dom';
import { QUESTION } from '../words/web-sheet';

export interface Question {
  title: string;
  paragraphs: string[];
  /** On the button that agrees. */
  yes: string;
  /** Whether agreeing discards something, so that Enter and the main button do not. */
  isRisky?: boolean;
}

/** Resolves when a button was pressed, or Escape. */
export function ask({ title, paragraphs, yes, isRisky = false }: Question): Promise<boolean> {
  const sheet = create('dialog', 'sheet question');
  const heading = create('h2', 'question-title', title);
  heading.id = 'question-title';
  sheet.setAttribute('aria-labelledby', heading.id);
  const form = create('form', 'question-page');
  form.method = 'dialog';
  const buttons = create('div', 'question-buttons');
  const [no, agree] = [answer(QUESTION.cancel, ''), answer(yes, 'yes')];
  const usual = isRisky ? no : agree;
  usual.classList.add('primary');
  usual.autofocus = true;
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
