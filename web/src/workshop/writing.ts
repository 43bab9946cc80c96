// What makes files, apart from glTF.

export { joinedObj } from '../files/joined-obj';
export { atlasPng, heatMapPng } from '../files/png-file';
export { atlasSvg } from '../files/svg-text';
export { joined } from '../mesh/weld';
