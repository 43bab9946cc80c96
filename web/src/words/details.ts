// The other tabs of the details.

import { type Bound, counted, measure } from './format';

export const VALIDITY = { valid: 'valid', notValid: 'not valid', column: 'Valid' };

/** What runs in a tab of the details. */
export const TAB_JOBS = { stop: 'Stop', stopped: 'Stopped', starting: 'Starting' };

/** By abflat's names. */
export const SOLVERS = {
  activeSet: 'Active set',
  interiorPoint: 'Interior point',
  tutte: "Tutte's embedding",
};

/** How the solver found a layout. */
export const SOLVER = {
  hint: 'Point at a step to see its numbers.',
  summary: (solver: string, steps: number, converged: boolean, residual: number) => {
    const end = converged
      ? `converged to ${measure(residual)}`
      : `not converged (${measure(residual)})`;
    return `${solver}, ${counted(steps, 'step')}, ${end}`;
  },
};

/** The tab that plots distortion over t. */
export const SWEEP = {
  start: 'Plot against t',
  hint: 'Select a point to use its t.',
  progress: (done: number, all: number) => `${done} of ${all}`,
  skipped: (values: Bound[]) => `${values.join(', ')}: not possible for this mesh`,
};

/** The tab that compares methods. */
export const METHODS = {
  start: 'Compare methods',
  progress: (fraction: number) => `${Math.round(100 * fraction)}\u202f%`,
  caption: 'Methods',
  method: 'Method',
};

/** Copying all numbers of a result. */
export const REPORT = {
  copied: 'Statistics copied as JSON',
  notCopied: 'Nothing was copied, because the browser blocks the clipboard for this page.',
  allow:
    'Allow it in the site settings, next to the address. If there is no such setting, open the page over https or from localhost.',
};
