import type { OrthographicCamera } from 'three';
import { type Box, middleOf } from '../arrange/charts';
import { inPlane, type Motion, type Point } from '../arrange/motion';
import type { LayoutDrawing } from '../model/drawing';
import { FitRoom } from './fit-room';
import { PanZoom } from './pan-zoom';
import type { Pixel } from './sight';
import type { TilePlacement } from './tile-labels';

type Layout = Pick<LayoutDrawing, 'size' | 'tiles' | 'middle' | 'unit'>;

/** The part of the layout's plane that a canvas shows, and where its points appear. */
export class UvPlane {
  private readonly panZoom: PanZoom;
  private readonly room: FitRoom;
  /** Of the canvas, in css pixels. */
  private pane = { width: 1, height: 1 };
  private layout: Layout = { size: [1, 1], tiles: 0, middle: [0, 0], unit: 1 };
  /** Until the user pans or zooms, the layout stays fitted however it or the pane changes. */
  private isFitted = true;
  private showsImage = false;
  private moved: () => void = () => undefined;
  private mayPan: () => boolean = () => true;

  /** `changed` is called when another part is shown. */
  constructor(
    private readonly camera: OrthographicCamera,
    canvas: HTMLCanvasElement,
    private readonly changed: () => void,
  ) {
    this.room = new FitRoom(canvas, () => this.refit());
    this.panZoom = new PanZoom(canvas, {
      isFree: () => this.mayPan(),
      moved: () => {
        this.isFitted = false;
        this.moved();
        this.changed();
      },
      fit: () => this.fit(),
    });
  }

  /** `moved` is called when the user has moved to another part. */
  onMove(moved: () => void): void {
    this.moved = moved;
  }

  /** Drags pan only when `mayPan`. */
  setPanning(mayPan: () => boolean): void {
    this.mayPan = mayPan;
  }

  /** Another layout is shown. Keeps the point of view unless `isNew`. */
  show({ size, tiles, middle, unit }: Layout, isNew: boolean): void {
    this.layout = { size, tiles, middle, unit };
    if (isNew || this.isFitted) this.fit();
  }

  /** Whether an image fills the unit square, which a layout in one piece need not do. */
  setImage(showsImage: boolean): void {
    this.showsImage = showsImage;
    this.refit();
  }

  resize(width: number, height: number): void {
    this.pane = { width, height };
    this.refit();
  }

  /** Shows all of the layout. */
  fit(): void {
    const { size, tiles, middle, unit } = this.layout;
    const [u, v] = middle;
    if (this.showsImage && tiles === 0)
      this.look([(0.5 - u) / unit, (0.5 - v) / unit], [1 / unit, 1 / unit]);
    else this.look([0, 0], size);
    this.isFitted = true;
  }

  private refit(): void {
    if (this.isFitted) this.fit();
  }

  /** Shows a part of the plane. */
  goTo(box: Box): void {
    this.look(middleOf(box), [box.high[0] - box.low[0], box.high[1] - box.low[1]]);
    this.isFitted = false;
  }

  private look([x, y]: Point, size: [number, number]): void {
    const { width, height } = this.pane;
    const { side, top, bottom } = this.room.margins(this.pane, this.layout.tiles > 0);
    const across = (width - 2 * side) / (size[0] || 1);
    const down = (height - top - bottom) / (size[1] || 1);
    const scale = Math.min(across, down);
    this.panZoom.set(x, y + (top - bottom) / 2 / scale, scale);
    this.changed();
  }

  /** Where a point of the plane appears. */
  pixelOf(x: number, y: number): Pixel {
    const { width, height } = this.pane;
    const { x: midX, y: midY, scale } = this.panZoom;
    return { x: width / 2 + (x - midX) * scale, y: height / 2 - (y - midY) * scale };
  }

  /** The point of uv at a pixel. */
  uvAt({ x, y }: Pixel): Point {
    const { x: midX, y: midY, scale } = this.panZoom;
    const [right, up] = [x - this.pane.width / 2, this.pane.height / 2 - y];
    return this.toUv([midX + right / scale, midY + up / scale]);
  }

  /** Css pixels per unit of uv. */
  get pixelsPerUv(): number {
    return this.panZoom.scale / this.layout.unit;
  }

  boxInUv({ low, high }: Box): Box {
    return { low: this.toUv(low), high: this.toUv(high) };
  }

  private toUv([x, y]: Point): Point {
    const { middle, unit } = this.layout;
    return [middle[0] + unit * x, middle[1] + unit * y];
  }

  /** A motion of uv in the plane. */
  motionOf(motion: Motion): Motion {
    return inPlane(motion, this.layout.middle, this.layout.unit);
  }

  /** Lets the camera see what is to be shown. */
  aim(): void {
    const { x, y, scale } = this.panZoom;
    const [halfWidth, halfHeight] = [this.pane.width / scale / 2, this.pane.height / scale / 2];
    this.camera.left = x - halfWidth;
    this.camera.right = x + halfWidth;
    this.camera.bottom = y - halfHeight;
    this.camera.top = y + halfHeight;
    this.camera.updateProjectionMatrix();
  }

  /** Where tiles appear. */
  get tilePlacement(): TilePlacement {
    const { width, height } = this.pane;
    const side = this.pixelsPerUv;
    const { x, y, scale } = this.panZoom;
    const [u0, v0] = this.layout.middle;
    return {
      x: (u) => width / 2 + (u - u0) * side - x * scale,
      y: (v) => height / 2 - (v - v0) * side + y * scale,
      side,
      width,
      height,
    };
  }
}
