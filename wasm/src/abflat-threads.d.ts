// The same module with vector instructions and threads.
export { default } from './abflat.js';
