// What saves files, and says what they hold.

export { savePictureOf } from './atlas-pictures';
export { exportMesh } from './export-mesh';
export { showLimits } from './format-limits';
