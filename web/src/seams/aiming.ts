// What is found under the pointer while seams are edited, which is not part of the first load.

export { ShortestPaths } from '../surface/shortest-paths';
export { edgeAt, edgeAwayFromEnds } from './pick';
export { endsOf, placeAt, targetsOf } from './seam-targets';
