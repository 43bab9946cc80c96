// What is done to charts of an atlas.

export { chartMesh } from '../arrange/chart-mesh';
export { atDensity, evened, keptDensities } from '../arrange/density';
export { fileStacks } from '../arrange/file-stacks';
export { movedUv } from '../arrange/move-charts';
export { sameShapes } from '../arrange/same-shape';
export { stacked } from '../arrange/stack';
export { apart, restacked, stacksOf } from '../arrange/stacks';
export { straightened } from '../arrange/straighten';
export { connectedParts } from '../mesh/connected-parts';
