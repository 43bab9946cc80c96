import { SAMPLE_NAMES } from 'abflat';
import { create, element } from '../base/dom';
import { MenuButton } from '../controls/menu-button';
import { sampleTitle } from '../session/titles';
import { ABOUT_SAMPLES, SAMPLES } from '../words/opening';

/** Samples that are files beside the page, which abflat does not make itself. */
const FILES: Record<string, string> = { pumpkin: 'pumpkin.glb' };

const addressOf = (file: string) => new URL(`./samples/${file}`, document.baseURI);

export interface SampleEvents {
  /** A mesh that abflat makes. */
  made(name: string): void;
  file(url: URL): void;
}

/** The button with the name of the sample that is open, and the menu of all with a picture of each. */
export class Samples {
  constructor(events: SampleEvents) {
    const names = [...new Set<string>([...SAMPLE_NAMES, ...Object.keys(FILES)])];
    element('sample-menu', HTMLElement).append(...names.map(itemOf));
    new MenuButton('sample', 'sample-menu', (name) => {
      const file = FILES[name];
      if (file) events.file(addressOf(file));
      else events.made(name);
    });
  }
}

/** Its picture is fetched when the menu is first opened. */
function itemOf(name: string): HTMLElement {
  const item = create('button', 'sample-item');
  item.type = 'button';
  item.tabIndex = -1;
  item.dataset.value = name;
  item.role = 'menuitemradio';
  item.ariaChecked = 'false';
  const picture = create('img', 'sample-picture');
  picture.loading = 'lazy';
  picture.alt = '';
  picture.width = 112;
  picture.height = 84;
  picture.src = addressOf(`${name}.webp`).href;
  item.append(
    picture,
    create('span', 'sample-name', sampleTitle(name)),
    create('span', 'sample-about', ABOUT_SAMPLES[name] ?? ''),
  );
  return item;
}

/** Shows which sample is open; none for a file. */
export function showSample(name: string | null): void {
  const button = element('sample', HTMLButtonElement);
  const title = name === null ? SAMPLES.samples : sampleTitle(name);
  button.value = name ?? '';
  button.ariaLabel = name === null ? SAMPLES.samples : SAMPLES.sample(title);
  element('sample-text', HTMLElement).textContent = title;
  for (const item of document.querySelectorAll<HTMLElement>('.sample-item'))
    item.ariaChecked = String(item.dataset.value === name);
}
