// Exporting and saving.

import { count, ended } from './format';

/** `format` in capitals. */
export const EXPORT = {
  export: (format: string) => `Export ${format}`,
  baked: (format: string) => `baked ${format}`,
  exportLast: 'Export last layout',
  previous: (settings: string) => `Exports the layout still on screen: ${settings}`,
  notExported: 'Not exported',
  cancelled: 'Export cancelled',
};

/** Files that were saved. */
export const SAVED = {
  saved: (name: string, size: string) => `Saved ${name}, ${size}`,
  kilobytes: (bytes: number) => `${count(Math.ceil(bytes / 1024))}\u202fKB`,
  pixels: (width: number, height: number) => `${count(width)}\u202f×\u202f${count(height)}\u202fpx`,
};

/** Why nothing is saved. */
export const SAVING = {
  notDrawn: 'Nothing is drawn, so there is no picture',
  failed: (title: string, message: string) => `${title} was not saved: ${ended(message)}`,
};

/** Pictures of an atlas. */
export const ATLAS_PICTURE = {
  tooLarge: (most: number) =>
    `a picture can have at most ${most} pixels per side. Lower the resolution, or save SVG`,
  noMemory:
    'the browser does not have enough memory for a picture this large. Lower the resolution, or save SVG',
};
