import { Color, type ShaderMaterial } from 'three';
import { element } from '../base/dom';
import { texelsBetween } from '../mesh/texels';
import { GRID } from '../words/view';
import { tileSheet, tileSquares } from './tile-sheet';
import { CELLS } from './uv-grid';

/** Every so many lines, one is stronger. */
const STRONG = 8;

const FRAGMENT = /* glsl */ `
  uniform float lines;
  uniform vec3 color;
  varying vec2 vPoint;
  float coverage(float count) {
    vec2 at = vPoint * count;
    vec2 away = abs(fract(at - 0.5) - 0.5) / fwidth(at);
    return 1.0 - min(min(away.x, away.y), 1.0);
  }
  void main() {
    float alpha = max(0.22 * coverage(lines), 0.5 * coverage(lines / ${STRONG}.0));
    gl_FragColor = vec4(color, alpha);
    #include <colorspace_fragment>
  }
`;

/** Lines below the charts of an atlas, a power of two of texels apart, and how many that are. */
export class TexelGrid {
  readonly object;
  private readonly info = element('grid-info', HTMLElement);
  /** Along a side of a tile; null: there are no texels. */
  private resolution: number | null = null;
  /** Over a picture there are lines only between single texels. */
  private isOnPicture = false;
  private hasCells = false;

  /** `layout`: the material of the charts, whose plane it shares. */
  constructor(layout: ShaderMaterial) {
    this.object = tileSheet(layout, FRAGMENT, {
      lines: { value: 1 },
      color: { value: new Color() },
    });
  }

  setColor(color: Color): void {
    this.object.material.uniforms.color.value = color;
  }

  setResolution(texels: number | null): void {
    this.resolution = texels;
  }

  /** What the charts show: a picture of one's own, or the numbered grid. */
  setSurroundings(isOnPicture: boolean, hasCells: boolean): void {
    this.isOnPicture = isOnPicture;
    this.hasCells = hasCells;
  }

  show(tiles: number): void {
    this.object.geometry.dispose();
    this.object.geometry = tileSquares(tiles);
  }

  /** The layout appears in this size. */
  update(pixelsPerUv: number): void {
    const { resolution, object } = this;
    const texels = resolution && texelsBetween(resolution, pixelsPerUv);
    object.visible = texels !== null && (!this.isOnPicture || texels === 1);
    if (resolution && texels) object.material.uniforms.lines.value = resolution / texels;
    const text =
      resolution && this.hasCells
        ? GRID.cells(resolution / CELLS)
        : texels && object.visible
          ? GRID.lines(texels)
          : '';
    if (this.info.textContent !== text) this.info.textContent = text;
  }
}
