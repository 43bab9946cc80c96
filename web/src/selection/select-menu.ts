import { create, element } from '../base/dom';
import { MenuButton } from '../controls/menu-button';
import { CHOOSING } from '../words/choosing';

/** Keys that do the same. */
const KEYS = { box: 'B', lasso: 'B B', all: 'A', none: 'Alt+A', invert: 'I' } as const;
/** Two side by side. */
const ENTRIES = [
  ...(['box', 'lasso', 'all', 'none', 'invert', 'shape'] as const),
  ...(['material', 'group', 'overlapping', 'flipped'] as const),
];

/** What the menu offers, besides limits of the stretch, which are numbers. */
export type SelectName = (typeof ENTRIES)[number];

const LIMITS = [1.02, 1.05, 1.1, 1.2];

/** The button above the layout whose menu selects charts. */
export class SelectMenu {
  constructor(chosen: (how: SelectName | number) => void) {
    const button = create('button', 'tool', CHOOSING.button);
    button.type = 'button';
    button.id = 'select-charts';
    button.title = CHOOSING.title;
    button.setAttribute('aria-haspopup', 'menu');
    button.setAttribute('aria-controls', 'select-menu');
    button.ariaExpanded = 'false';
    const menu = create('div', 'menu');
    menu.id = 'select-menu';
    menu.role = 'menu';
    menu.ariaLabel = CHOOSING.menu;
    menu.hidden = true;
    menu.append(...ENTRIES.map(entry), limits());
    // Where there is room for it.
    element('layout-stage', HTMLElement).append(menu);
    element('delaunay', HTMLElement).before(button);
    new MenuButton(button.id, menu.id, (value) => chosen(Number(value) || (value as SelectName)));
  }
}

function entry(name: SelectName): HTMLButtonElement {
  const made = item(name, CHOOSING[name]);
  const about: Partial<Record<SelectName, string>> = CHOOSING.about;
  made.title = about[name] ?? '';
  if (name in KEYS) made.append(create('kbd', '', KEYS[name as keyof typeof KEYS]));
  return made;
}

function limits(): HTMLElement {
  const group = create('div', 'select-limits');
  group.role = 'group';
  group.ariaLabel = CHOOSING.stretched;
  for (const limit of LIMITS) {
    const made = item(String(limit), String(limit));
    made.title = CHOOSING.aboutStretched(limit);
    group.append(made);
  }
  return group;
}

function item(value: string, text: string): HTMLButtonElement {
  const made = create('button', '', text);
  made.type = 'button';
  made.role = 'menuitem';
  made.tabIndex = -1;
  made.dataset.value = value;
  return made;
}
