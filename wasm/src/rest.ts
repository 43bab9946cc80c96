// What few calls need, loaded with the first of them. In one file: each costs a little.

export { Baker } from './baker.js';
export { openPool } from './pool.js';
export { verifyCall } from './verify-call.js';
