import { triangleAreas } from '../mesh/mesh';
import { ATLAS_PICTURE } from '../words/exported';
import { type ChartLines, chartLines } from './chart-lines';
import { HEAT_STEPS, heatColor, heatSteps } from './heat';
import { pictureSize } from './picture-size';
import type { AtlasDrawing } from './svg-text';

const INK = '#1b2430';
const [THIN, THICK] = [1, 2];

/**
 * One pixel per texel: charts in their colours, thin edges, thick outlines, transparent between
 * charts.
 */
export async function atlasPng(drawing: AtlasDrawing): Promise<Blob> {
  const canvas = new Painter(drawing);
  const lines = chartLines(drawing);
  lines.forEach(({ outline }, chart) => {
    canvas.fill(outline, drawing.colors[chart]);
  });
  canvas.strokeInner(lines);
  canvas.strokeOutlines(lines);
  return canvas.file();
}

/**
 * The same, but each triangle is coloured by its area in uv relative to its area in 3D; `positions`
 * are those of the vertices.
 */
export async function heatMapPng(drawing: AtlasDrawing, positions: Float64Array): Promise<Blob> {
  const canvas = new Painter(drawing);
  const { uv, indices } = drawing;
  canvas.fillTriangles(
    indices,
    heatSteps(triangleAreas(positions, 3, indices), triangleAreas(uv, 2, indices)),
  );
  canvas.strokeOutlines(chartLines(drawing));
  return canvas.file();
}

/** A canvas with one pixel per texel; v goes up, rows go down. */
class Painter {
  private readonly canvas = new OffscreenCanvas(1, 1);
  private readonly context: OffscreenCanvasRenderingContext2D;

  constructor(private readonly drawing: AtlasDrawing) {
    const { width, height } = pictureSize(drawing);
    this.canvas.width = width;
    this.canvas.height = height;
    const context = this.canvas.getContext('2d');
    if (!context) throw noMemory();
    this.context = context;
    context.lineJoin = 'round';
    context.lineCap = 'round';
    context.strokeStyle = INK;
  }

  fill(runs: number[][], color: string): void {
    this.context.fillStyle = color;
    this.context.fill(this.path(runs));
  }

  /**
   * Fills all triangles of a step at once, drawn slightly larger so that no gaps show between them.
   */
  fillTriangles(indices: Uint32Array, steps: Int8Array): void {
    const runs: number[][][] = Array.from({ length: HEAT_STEPS + 1 }, () => []);
    steps.forEach((step, f) => {
      const [i, j, k] = indices.subarray(3 * f, 3 * f + 3);
      runs[step + 1].push([i, j, k, i]);
    });
    runs.forEach((own, i) => {
      if (own.length === 0) return;
      const color = heatColor(i - 1);
      const path = this.path(own);
      this.context.fillStyle = color;
      this.context.strokeStyle = color;
      this.context.lineWidth = THIN;
      this.context.fill(path);
      this.context.stroke(path);
    });
    this.context.strokeStyle = INK;
  }

  /** Drawn faintly if dense: edges as dense as pixels would hide the colours. */
  strokeInner(lines: ChartLines[]): void {
    const runs = lines.flatMap(({ inner }) => inner);
    this.context.globalAlpha = Math.max(0.08, 0.45 * Math.min(1, this.meanLength(runs) / 12));
    this.stroke(runs, THIN);
    this.context.globalAlpha = 1;
  }

  strokeOutlines(lines: ChartLines[]): void {
    this.stroke(
      lines.flatMap(({ outline }) => outline),
      THICK,
    );
  }

  async file(): Promise<Blob> {
    return this.canvas.convertToBlob({ type: 'image/png' }).catch(() => {
      throw noMemory();
    });
  }

  private stroke(runs: number[][], width: number): void {
    this.context.lineWidth = width;
    this.context.stroke(this.path(runs));
  }

  private place(v: number): [number, number] {
    const { uv, resolution } = this.drawing;
    return [uv[2 * v] * resolution, this.canvas.height - uv[2 * v + 1] * resolution];
  }

  private path(runs: number[][]): Path2D {
    const path = new Path2D();
    for (const run of runs) {
      run.forEach((v, i) => {
        if (i === 0) path.moveTo(...this.place(v));
        else path.lineTo(...this.place(v));
      });
      if (run[0] === run[run.length - 1]) path.closePath();
    }
    return path;
  }

  /** Mean length of the edges of these runs, in pixels. */
  private meanLength(runs: number[][]): number {
    let [sum, count] = [0, 0];
    for (const run of runs)
      for (let i = 1; i < run.length; ++i) {
        const [[x0, y0], [x1, y1]] = [this.place(run[i - 1]), this.place(run[i])];
        sum += Math.hypot(x1 - x0, y1 - y0);
        count += 1;
      }
    return count > 0 ? sum / count : 0;
  }
}

const noMemory = () => new Error(ATLAS_PICTURE.noMemory);
