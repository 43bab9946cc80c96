// What the sheet of keys shows.

import '../css/help-groups.css';
import { create } from '../base/dom';
import { KEY_NAMES } from '../words/help';
import { CONTROLS, type Control, type ControlGroup } from './keys';

export const helpGroups = (): HTMLElement[] => CONTROLS.map(section);

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
