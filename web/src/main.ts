import './style.css';
import { createAbflat } from 'abflat';
import { hideAlert, showAlert } from './alert';
import { App } from './app';
import { element } from './dom';
import { Views } from './views';

async function start(): Promise<void> {
  const abflat = await createAbflat();
  new App(abflat, createViews());
}

/** Without WebGL numbers and export still work. */
function createViews(): Views | null {
  try {
    return new Views();
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    for (const id of ['mesh-stage', 'layout-stage']) {
      const note = document.createElement('p');
      note.className = 'no-webgl';
      note.textContent =
        'This browser shows no pictures here because WebGL 2 is off or missing. Flattening, numbers and export work all the same.';
      element(id, HTMLElement).replaceChildren(note);
    }
    console.info('No WebGL:', why);
    return null;
  }
}

hideAlert();
start().catch((error: unknown) => {
  showAlert(
    'abflat could not start.',
    `${error instanceof Error ? error.message : String(error)} Reload the page to try again.`,
  );
  element('run-text', HTMLElement).textContent = 'Not started';
});
