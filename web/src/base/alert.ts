import { ALERT } from '../words/base';
import { create, element } from './dom';
import { messageHidden, messageShown } from './messages';

const box = element('alert', HTMLElement);

/** Shows a sentence about what went wrong, until it is closed, by Escape too, or `hideAlert` is called. */
export function showAlert(sentence: string, detail = ''): void {
  const close = create('button', 'alert-close', '×');
  close.type = 'button';
  close.setAttribute('aria-label', ALERT.close);
  close.addEventListener('click', hideAlert);
  const text = create('div', 'alert-text');
  text.append(create('p', '', sentence));
  if (detail) text.append(create('p', 'alert-detail', detail));
  box.replaceChildren(text, close);
  messageShown(box, hideAlert);
}

/** It is read, or something else has gone well since. */
export function hideAlert(): void {
  messageHidden(box);
  box.replaceChildren();
}
