// What is done to charts of an atlas.

export { chartMeshes } from '../arrange/chart-mesh';
export { atDensity, evened, keptDensities } from '../arrange/density';
export { fileIslands } from '../arrange/file-islands';
export { fileStacks } from '../arrange/file-stacks';
export { flipped } from '../arrange/flip';
export { movedUv } from '../arrange/move-charts';
export { sameShapes } from '../arrange/same-shape';
export { stacked } from '../arrange/stack';
export { apart, restacked, stacksOf } from '../arrange/stacks';
export { straightened } from '../arrange/straighten';
export { connectedParts } from '../mesh/connected-parts';
