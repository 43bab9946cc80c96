// The same module with vector instructions.
export { default } from './abflat.js';
