import './style.css';
import { createAbflat } from 'abflat';
import { hideAlert, showAlert } from './alert';
import { App } from './app';
import { create, element } from './dom';
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
      const text =
        'No picture: WebGL 2 is off or missing in this browser. Flattening, numbers and export work all the same.';
      element(id, HTMLElement).append(create('p', 'no-webgl', text));
    }
    for (const id of ['mesh-canvas', 'layout-canvas']) element(id, HTMLElement).hidden = true;
    for (const id of ['wireframe', 'distortion', 'reset', 'fit'])
      element(id, HTMLButtonElement).disabled = true;
    console.info(why);
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
