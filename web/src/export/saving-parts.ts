// What saves files.

export { savePictureOf } from './atlas-pictures';
export { exportMesh } from './export-mesh';
