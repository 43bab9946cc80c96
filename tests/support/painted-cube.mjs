import { waves } from './made-images.mjs';
import { encodedPng } from './made-png.mjs';
import { oneTexture, texturedCube, texturedGlb } from './textured.mjs';

const { data, width, height } = waves(96);

/** A cube, or some of its triangles, with a colourful texture, as GLB. */
export const paintedCube = (triangles = texturedCube().triangles) =>
  texturedGlb([{ ...texturedCube(), triangles }], oneTexture(encodedPng(width, height, data)));
