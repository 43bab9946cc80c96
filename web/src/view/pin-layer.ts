import {
  BufferAttribute,
  type BufferGeometry,
  type Mesh,
  type ShaderMaterial,
  type Vector2,
} from 'three';
import type { Point } from '../arrange/motion';
import type { Palette } from '../colors/palette';
import { type Bending, bentOutline, cornerWeights } from './bending';
import type { ChartEdges } from './chart-edges';
import { PointMarks } from './point-marks';

/** Css pixels. */
const PIN = { size: 11, hole: 0 };
const HALO = { size: 15, hole: 0 };
const AIM = { size: 17, hole: 0.7 };

const NO_POINTS = new Float32Array();

/** What is drawn of pins: marks on the vertices, and the chart that one of them bends. */
export class PinLayer {
  private readonly halos = new PointMarks({ ...HALO, depthTest: false });
  private readonly pins = new PointMarks({ ...PIN, depthTest: false });
  private readonly aim = new PointMarks({ ...AIM, depthTest: false });
  private bending: Bending | null = null;
  private toPlane: (uv: Point) => Point = (uv) => uv;
  private unit = 1;
  /** In uv. */
  private shown: { pins: readonly Point[]; aimed: Point | null } = { pins: [], aimed: null };

  constructor(
    private readonly surface: { object: Mesh },
    private readonly material: ShaderMaterial,
    private readonly edges: ChartEdges,
  ) {}

  get objects() {
    return [this.halos.object, this.pins.object, this.aim.object];
  }

  /** Another layout is shown, as is. Its pins may have come before. */
  setPlane(middle: Point, unit: number): void {
    this.unit = unit;
    this.toPlane = ([u, v]) => [(u - middle[0]) / unit, (v - middle[1]) / unit];
    this.draw();
  }

  setPalette({ background, tightened, boundary }: Palette): void {
    this.halos.setColor(background);
    this.pins.setColor(boundary);
    this.aim.setColor(tightened);
  }

  setPixelRatio(ratio: number): void {
    for (const marks of [this.halos, this.pins, this.aim]) marks.setPixelRatio(ratio);
  }

  /** Points are in uv; `aimed` is what a click would hit. Returns whether there is anything else to see. */
  show(pins: readonly Point[], aimed: Point | null): boolean {
    const wasEmpty = this.shown.pins.length === 0 && !this.shown.aimed;
    this.shown = { pins, aimed };
    if (wasEmpty && pins.length === 0 && !aimed) return false;
    this.draw();
    return true;
  }

  private draw(): void {
    const { pins, aimed } = this.shown;
    const points = this.pointsOf(pins);
    this.halos.show(points);
    this.pins.show(points);
    this.aim.show(aimed ? this.pointsOf([aimed]) : NO_POINTS);
  }

  private pointsOf(points: readonly Point[]): Float32Array {
    return Float32Array.from(points.flatMap((point) => [...this.toPlane(point), 0]));
  }

  /**
   * Shows a chart as one of its pins bends it when it is dragged `by` in uv; null: as it is.
   * `charts`: whose edges are those of the bent chart.
   */
  bend(bending: Bending | null, by: Point, charts: ReadonlySet<number> = new Set()): void {
    const { bend } = this.material.uniforms as { bend: { value: Vector2 } };
    bend.value.set(by[0] / this.unit, by[1] / this.unit);
    if (bending && bending !== this.bending) this.upload(bending);
    this.bending = bending;
    if (bending) this.edges.replace(charts, bentOutline(bending, by, this.toPlane));
  }

  private upload(bending: Bending): void {
    const { geometry } = this.surface.object;
    const weights = this.weightsOf(geometry);
    cornerWeights(bending, weights.array as Float32Array);
    weights.needsUpdate = true;
  }

  private weightsOf(geometry: BufferGeometry): BufferAttribute {
    const { count } = geometry.getAttribute('position');
    const shown = geometry.getAttribute('weight');
    if (shown instanceof BufferAttribute && shown.count === count) return shown;
    const made = new BufferAttribute(new Float32Array(2 * count), 2);
    geometry.setAttribute('weight', made);
    return made;
  }
}
