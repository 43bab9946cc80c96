// The keys on the sheet of keys.

import { loadModule } from './modules.mjs';

export const { CONTROLS } = await loadModule('help/keys');

export const keysOf = (title) =>
  CONTROLS.find((group) => group.title === title).controls.flatMap(({ keys }) => keys);

export const isOpen = (page) => page.locator('#help-sheet').evaluate((sheet) => sheet.open);
