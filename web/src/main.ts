import './css/style.css';
import { type Abflat, createAbflat } from 'abflat';
import { App } from './app';
import { create, element } from './base/dom';
import { keepOffline } from './base/offline';
import { startOnce } from './base/start-once';
import { NoWebGl } from './view/stage';
import { Views } from './view/views';
import { SHOWN } from './words/view';

/** Without WebGL, numbers and export still work. */
function createViews(): Views | null {
  try {
    return new Views();
  } catch (error) {
    if (!(error instanceof NoWebGl)) throw error;
    for (const id of ['mesh-stage', 'layout-stage'])
      element(id, HTMLElement).append(create('p', 'no-webgl', SHOWN.noWebGl));
    for (const id of ['mesh-canvas', 'layout-canvas', 'seam-tools'])
      element(id, HTMLElement).hidden = true;
    for (const id of ['wireframe', 'other-side', 'reset', 'fit'])
      element(id, HTMLButtonElement).disabled = true;
    element('shading', HTMLSelectElement).disabled = true;
    return null;
  }
}

const views = createViews();

/** Compiles the shaders in the meantime. */
async function start(): Promise<Abflat> {
  const [abflat] = await Promise.all([createAbflat(), views?.ready]);
  keepOffline(abflat.build);
  return abflat;
}

new App(startOnce(start), views);
