// The package's types: its calls, and their arguments and results.

export type * from '../base/generated-report.js';
export type * from './abflat.js';
export type * from './bake.js';
export type * from './compare.js';
export type * from './create.js';
export type * from './flatten.js';
export type * from './layout.js';
export type * from './mesh.js';
export type * from './pack.js';
export type * from './unwrap.js';
export type * from './verify.js';
