import { BufferAttribute, BufferGeometry, Mesh, OrthographicCamera, Scene } from 'three';
import { crossings } from './crossings';
import { EdgeLines } from './edge-lines';
import { createLayoutMaterial, paintLayout } from './layout-material';
import { boundingBox, perCorner, toCorners } from './mesh';
import type { Palette } from './palette';
import { PanZoom } from './pan-zoom';
import type { FlatPicture } from './picture';
import { DOT, PointMarks, RING } from './point-marks';
import { Stage } from './stage';
import { NONE_LIT } from './surface-material';
import { TileLabels } from './tile-labels';
import { tileFrames, tileGrid } from './tiles';

/** Css pixels between a fitted layout and the border of its pane. */
const MARGIN = 28;
/** Crossings that are marked; more would only be a red blot. */
const MOST_MARKS = 500;

/** Css pixels: charts may be many and small. */
const OUTLINE = 2.25;
const THIN_OUTLINE = 1.25;

/** The uv layout in the plane. */
export class LayoutView {
  private readonly stage: Stage;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1, 1);
  private readonly material = createLayoutMaterial();
  private readonly surface = new Mesh(new BufferGeometry(), this.material);
  private readonly frame = new EdgeLines(1.5, false);
  private readonly boundary = new EdgeLines(OUTLINE, false);
  private readonly resisting = new EdgeLines(2.5, false);
  private readonly dots = new PointMarks({ ...DOT, depthTest: false });
  private readonly rings = new PointMarks({ ...RING, depthTest: false });
  private readonly panZoom: PanZoom;
  /** Size of the shown layout, whose centre is 0 and whose longer side is 1. */
  private size: [number, number] = [1, 1];
  /** In uv: what is at 0 of the plane, and the length of a unit of it. */
  private middle = [0, 0];
  private unit = 1;
  private readonly labels = new TileLabels();
  /** Until the user pans or zooms, the layout stays fitted whatever happens to it or to the pane. */
  private isFitted = true;
  /** The chart of each shown triangle. */
  private pieces = new Float32Array();

  constructor(canvas: HTMLCanvasElement) {
    this.panZoom = new PanZoom(canvas, {
      moved: () => {
        this.isFitted = false;
        this.stage.invalidate();
      },
      fit: () => this.fit(),
    });
    this.stage = new Stage(
      canvas,
      () => this.draw(),
      () => this.resized(),
    );
    this.surface.frustumCulled = false;
    this.scene.add(
      this.frame.object,
      this.surface,
      this.boundary.object,
      this.resisting.object,
      this.dots.object,
      this.rings.object,
    );
    this.stage.resize();
  }

  /** Shows a layout. Keeps the point of view unless `isNew`. */
  show(picture: FlatPicture, isNew: boolean): void {
    const { mesh, edges, errors, tightened, resisting, chartColors, charts: pieces } = picture;
    const { tiles = 0 } = picture;
    const { min, max } = tiles
      ? { min: [0, 0], max: tileGrid(tiles) }
      : boundingBox(mesh.uv, 2, mesh.indices);
    this.unit = Math.max(max[0] - min[0], max[1] - min[1]) || 1;
    this.middle = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
    this.size = [(max[0] - min[0]) / this.unit, (max[1] - min[1]) / this.unit];
    const plane = this.toPlane(mesh.uv);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(perCorner(plane, 3, mesh.indices), 3));
    geometry.setAttribute('error', new BufferAttribute(toCorners(errors), 1));
    const charts = chartColors ?? new Float32Array(errors.length);
    geometry.setAttribute('chart', new BufferAttribute(toCorners(charts), 1));
    this.pieces = Float32Array.from(pieces ?? charts);
    geometry.setAttribute('piece', new BufferAttribute(toCorners(this.pieces), 1));
    this.material.uniforms.showsCharts.value = chartColors !== undefined;
    this.surface.geometry.dispose();
    this.surface.geometry = geometry;
    this.boundary.setWidth(chartColors ? THIN_OUTLINE : OUTLINE);
    this.boundary.show(plane, edges);
    this.resisting.show(plane, resisting);
    this.dots.show(perCorner(plane, 3, tightened));
    const frames = tileFrames(tiles);
    this.frame.show(this.toPlane(frames.points), frames.sides);
    this.labels.show(tiles);
    // Of an atlas the report says whether charts cross.
    const points = chartColors ? new Float64Array() : crossings(mesh.uv, edges, MOST_MARKS);
    this.rings.show(this.toPlane(points));
    if (isNew || this.isFitted) this.fit();
    else this.stage.invalidate();
  }

  /** From uv, 2 numbers per point, to what is drawn, 3 per point. */
  private toPlane(uv: Float64Array): Float32Array {
    const plane = new Float32Array((uv.length / 2) * 3);
    uv.forEach((x, i) => {
      const d = i % 2;
      plane[3 * Math.floor(i / 2) + d] = (x - this.middle[d]) / this.unit;
    });
    return plane;
  }

  setPalette(palette: Palette): void {
    this.stage.renderer.setClearColor(palette.background);
    paintLayout(this.material, palette);
    this.frame.setColor(palette.frame);
    this.boundary.setColor(palette.boundary);
    this.resisting.setColor(palette.flipped);
    this.dots.setColor(palette.tightened);
    this.rings.setColor(palette.flipped);
    this.stage.invalidate();
  }

  setDistortion(shows: boolean): void {
    this.material.uniforms.showsError.value = shows;
    this.stage.invalidate();
  }

  /** Shows one chart clearer than the others; null: all alike. */
  light(chart: number | null): void {
    this.material.uniforms.lit.value = chart ?? NONE_LIT;
    this.stage.invalidate();
  }

  /** Goes to one chart. */
  goTo(chart: number): void {
    const corners = this.surface.geometry.getAttribute('position').array;
    const low = [Infinity, Infinity];
    const high = [-Infinity, -Infinity];
    this.pieces.forEach((piece, f) => {
      if (piece !== chart) return;
      for (let c = 3 * f; c < 3 * f + 3; ++c)
        for (const d of [0, 1]) {
          low[d] = Math.min(low[d], corners[3 * c + d]);
          high[d] = Math.max(high[d], corners[3 * c + d]);
        }
    });
    if (low[0] > high[0]) return;
    this.look((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, [high[0] - low[0], high[1] - low[1]]);
    this.isFitted = false;
  }

  fit(): void {
    this.look(0, 0, this.size);
    this.isFitted = true;
  }

  private look(x: number, y: number, size: [number, number]): void {
    const margin = Math.min(MARGIN, this.stage.width / 14, this.stage.height / 14);
    const across = (this.stage.width - 2 * margin) / (size[0] || 1);
    const down = (this.stage.height - 2 * margin) / (size[1] || 1);
    this.panZoom.set(x, y, Math.min(across, down));
    this.stage.invalidate();
  }

  private resized(): void {
    this.material.uniforms.pixelRatio.value = this.stage.pixelRatio;
    for (const marks of [this.dots, this.rings]) marks.setPixelRatio(this.stage.pixelRatio);
    for (const lines of [this.frame, this.boundary, this.resisting])
      lines.setResolution(this.stage.width, this.stage.height);
    if (this.isFitted) this.fit();
  }

  private draw(): void {
    const { x, y, scale } = this.panZoom;
    const [halfWidth, halfHeight] = [this.stage.width / scale / 2, this.stage.height / scale / 2];
    this.camera.left = x - halfWidth;
    this.camera.right = x + halfWidth;
    this.camera.bottom = y - halfHeight;
    this.camera.top = y + halfHeight;
    this.camera.updateProjectionMatrix();
    this.stage.renderer.render(this.scene, this.camera);
    const { width, height } = this.stage;
    const [u0, v0] = this.middle;
    const side = scale / this.unit;
    this.labels.move({
      x: (u) => width / 2 + (u - u0) * side - x * scale,
      y: (v) => height / 2 - (v - v0) * side + y * scale,
      side,
      width,
      height,
    });
  }
}
