// The plots of the details.

import { type Bound, bound, count, measure } from './format';

/** The charts of the solver's steps. */
export const CONVERGENCE = {
  step: 'Step',
  residual: 'Residual',
  aboutResidual:
    'How far each solver step is from meeting the constraints and from minimal distortion.',
  constraint: 'Constraint',
  gradient: 'Gradient',
  constraintResidual: 'Constraint residual',
  gradientResidual: 'Gradient residual',
  activeSet: 'Active set',
  aboutActiveSet: 'How many boundary vertices and interior edges each step holds at their bounds.',
  vertices: 'Boundary vertices',
  edges: 'Interior edges',
  atStep: (step: number, constraint: number, gradient: number, vertices: number, edges: number) =>
    `Step ${step}: constraint ${measure(constraint)}, gradient ${measure(gradient)}, ${count(vertices)}${
      edges > 0 ? ` + ${count(edges)}` : ''
    } at their bound`,
};

/** The chart of distortion over t. */
export const SWEEP_CHART = {
  title: 'Angular distortion',
  about: 'Angular distortion for different values of t. Circles are layouts that are not valid.',
  t: 't',
  auto: 'auto',
  notPossible: 'not possible',
  yes: 'yes',
  no: 'no',
  point: (t: Bound, distortion: number, verdict: string) =>
    `t = ${bound(t)}: ${measure(distortion)}, ${verdict}.`,
};
