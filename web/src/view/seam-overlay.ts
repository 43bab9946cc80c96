import { Group } from 'three';
import type { Palette } from '../colors/palette';
import { perCorner } from '../mesh/mesh';
import { EdgeLines } from './edge-lines';
import { DOT, PointMarks } from './point-marks';

/** What is marked on the surface: edges that are about to be cut or joined, and vertices. */
export interface SeamMarks {
  /** Pairs of vertices. */
  cut: Uint32Array;
  joined: Uint32Array;
  /** Edges that could be cut instead. */
  offered: Uint32Array;
  vertices: Uint32Array;
}

export const NO_MARKS: SeamMarks = {
  cut: new Uint32Array(),
  joined: new Uint32Array(),
  offered: new Uint32Array(),
  vertices: new Uint32Array(),
};

const sameArray = (a: Uint32Array, b: Uint32Array) =>
  a.length === b.length && a.every((x, i) => x === b[i]);

const KINDS = ['cut', 'joined', 'offered', 'vertices'] as const;

const sameMarks = (a: SeamMarks, b: SeamMarks) =>
  KINDS.every((kind) => sameArray(a[kind], b[kind]));

const isEmpty = (marks: SeamMarks) => KINDS.every((kind) => marks[kind].length === 0);

/** Css pixels. */
const WIDTH = 4;
const THIN = 2;
const VERTEX = { ...DOT, size: 11 };

/** The marks in the 3D view. */
export class SeamOverlay {
  readonly object = new Group();
  private readonly cut = new EdgeLines(WIDTH, true);
  private readonly joined = new EdgeLines(WIDTH, true);
  private readonly offered = new EdgeLines(THIN, true);
  private readonly vertices = new PointMarks({ ...VERTEX, depthTest: true });
  private readonly lines: EdgeLines[];
  private points: Float32Array = new Float32Array();
  private marks: SeamMarks = NO_MARKS;

  constructor() {
    this.lines = [this.cut, this.joined, this.offered];
    this.object.add(...this.lines.map(({ object }) => object), this.vertices.object);
    for (const { object } of this.lines) object.renderOrder = 2;
    this.vertices.object.renderOrder = 3;
  }

  /** `points` has xyz per vertex. Returns whether anything changes. */
  show(points: Float32Array, marks: SeamMarks): boolean {
    const isSame = (points === this.points || isEmpty(marks)) && sameMarks(marks, this.marks);
    if (isSame) return false;
    this.points = points;
    this.marks = marks;
    const { cut, joined, offered, vertices } = marks;
    this.cut.show(perCorner(points, 3, cut));
    this.joined.show(perCorner(points, 3, joined));
    this.offered.show(perCorner(points, 3, offered));
    this.vertices.show(perCorner(points, 3, vertices));
    return true;
  }

  setPalette({ cut, flipped }: Palette): void {
    this.cut.setColor(cut);
    this.joined.setColor(flipped);
    this.offered.setColor(cut);
    this.vertices.setColor(cut);
  }

  setSize(width: number, height: number, pixelRatio: number): void {
    for (const lines of this.lines) lines.setResolution(width, height);
    this.vertices.setPixelRatio(pixelRatio);
  }
}
