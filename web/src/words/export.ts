// Exporting and saving.

import { ended } from './format';

/** `format` in capitals. */
export const EXPORT = {
  export: (format: string) => `Export ${format}`,
  baked: (format: string) => `baked ${format}`,
  /** An archive with an OBJ, its materials and its images. */
  zip: 'OBJ (zip)',
  exportLast: 'Export last layout',
  previous: (settings: string) => `Exports the layout still on screen: ${settings}`,
  notExported: 'Not exported',
  cancelled: 'Export cancelled',
};

/** Why nothing is saved. */
export const SAVING = {
  notDrawn: 'Nothing is drawn, so there is no picture',
  failed: (title: string, message: string) => `${title} was not saved: ${ended(message)}`,
};
