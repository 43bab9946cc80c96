import type { ShaderMaterial } from 'three';
import { tileSheet, tileSquares } from './tile-sheet';
import { PICTURE_GLSL } from './uv-picture';

const FRAGMENT = /* glsl */ `
  ${PICTURE_GLSL}
  varying vec2 vPoint;
  void main() {
    // Else the opposite side shines through at the border.
    vec2 border = 0.5 * max(1.0 / vec2(textureSize(picture, 0)), fwidth(vPoint));
    gl_FragColor = pictureColor(clamp(vPoint, border, 1.0 - border));
    #include <colorspace_fragment>
  }
`;

/** The picture in each tile, below the charts. */
export class PictureSheet {
  readonly object;

  /** `layout`: the material of the charts, whose picture and plane it shares. */
  constructor(layout: ShaderMaterial) {
    this.object = tileSheet(layout, FRAGMENT, { picture: layout.uniforms.picture });
  }

  show(tiles: number): void {
    this.object.geometry.dispose();
    this.object.geometry = tileSquares(tiles);
  }
}
