import type { ChartSpec, Column, Series, Shape } from './chart-spec';
import { svg } from './svg';

/** Css pixels around the plot. */
const LEFT = 50;
const RIGHT = 14;
const TOP = 8;
const BOTTOM = 20;
const NAME = 14;
const RADIUS = 4;
/** How far a column reaches beyond the outermost value. */
const REACH = 14;

/** Where the values of a chart lie in its picture, in css pixels. */
export interface Frame {
  left: number;
  right: number;
  top: number;
  bottom: number;
  x(value: number): number;
  y(value: number): number;
}

export function frameOf({ x, y, xName }: ChartSpec, width: number, height: number): Frame {
  const [left, right, top, bottom] = [
    LEFT,
    width - RIGHT,
    TOP,
    height - BOTTOM - (xName ? NAME : 0),
  ];
  return {
    left,
    right,
    top,
    bottom,
    x: (value) => left + x.at(value) * (right - left),
    y: (value) => bottom - y.at(value) * (bottom - top),
  };
}

/** Grid, tick labels and the name of the horizontal axis. */
export function drawAxes(spec: ChartSpec, frame: Frame): SVGGElement {
  const group = svg('g', { 'aria-hidden': 'true' });
  const { left, right, bottom } = frame;
  for (const { value, text } of spec.y.ticks) {
    const y = frame.y(value);
    group.append(
      svg('line', { class: 'chart-grid', x1: left, x2: right, y1: y, y2: y }),
      svg('text', { class: 'chart-tick', x: left - 6, y: y + 4, 'text-anchor': 'end' }, text),
    );
  }
  for (const { value, text } of spec.x.ticks) {
    const x = frame.x(value);
    group.append(
      svg('line', { class: 'chart-axis', x1: x, x2: x, y1: bottom, y2: bottom + 4 }),
      svg('text', { class: 'chart-tick', x, y: bottom + 16, 'text-anchor': 'middle' }, text),
    );
  }
  const middle = (left + right) / 2;
  group.append(
    svg('line', { class: 'chart-axis', x1: left, x2: right, y1: bottom, y2: bottom }),
    svg(
      'text',
      { class: 'chart-tick', x: middle, y: bottom + 30, 'text-anchor': 'middle' },
      spec.xName,
    ),
  );
  if (spec.current !== undefined) {
    const x = frame.x(spec.current);
    group.append(svg('line', { class: 'chart-current', x1: x, x2: x, y1: frame.top, y2: bottom }));
  }
  return group;
}

/** Line and marks; values that are not finite are left out. */
export function drawSeries({ color, shape, hasLine, marks }: Series, frame: Frame): SVGGElement {
  const group = svg('g', { class: `chart-series ${color}`, 'aria-hidden': 'true' });
  const shown = marks.filter(
    ({ x, y }) => Number.isFinite(frame.x(x)) && Number.isFinite(frame.y(y)),
  );
  if (hasLine) {
    const points = shown.map(({ x, y }) => `${frame.x(x).toFixed(1)},${frame.y(y).toFixed(1)}`);
    group.append(svg('polyline', { class: 'chart-line', points: points.join(' ') }));
  }
  group.append(
    ...shown.map((mark) =>
      drawMark(shape, frame.x(mark.x), frame.y(mark.y), hasLine ? RADIUS - 1.5 : RADIUS),
    ),
  );
  return group;
}

function drawMark(shape: Shape, cx: number, cy: number, r: number): SVGElement {
  if (shape !== 'diamond') return svg('circle', { class: `chart-mark ${shape}`, cx, cy, r });
  const d = 1.6 * r;
  const path = `M${cx} ${cy - d}l${d} ${d}l${-d} ${d}l${-d} ${-d}z`;
  return svg('path', { class: 'chart-mark diamond', d: path });
}

/** The symbol of a series in the legend. */
export function drawKey({ color, shape, hasLine }: Series): SVGSVGElement {
  const mark = hasLine
    ? svg('line', { class: 'chart-line', x1: 0, x2: 18, y1: 6, y2: 6 })
    : drawMark(shape, 9, 6, RADIUS);
  const attributes = { class: `chart-key chart-series ${color}`, viewBox: '0 0 18 12' };
  return svg('svg', { ...attributes, 'aria-hidden': 'true' }, mark);
}

export interface Rectangle {
  x: number;
  y: number;
  width: number;
  height: number;
}

/**
 * The part of the picture that belongs to each column: the points nearest to its x, and among those
 * the ones nearest to its y.
 */
export function columnAreas(columns: Column[], frame: Frame, height: number): Rectangle[] {
  const xs = [...new Set(columns.map(({ x }) => x))];
  const across = middles(xs.map(frame.x), (xs.length > 0 ? frame.x(xs[0]) : 0) - REACH, REACH);
  return columns.map((column) => {
    const i = xs.indexOf(column.x);
    // From top to bottom of the picture.
    const ys = columns.filter(({ x }) => x === column.x).map(({ y = 0 }) => y);
    ys.sort((a, b) => b - a);
    const down = middles(ys.map(frame.y), 0, 0);
    down[down.length - 1] = height;
    const j = ys.indexOf(column.y ?? 0);
    return {
      x: across[i],
      y: down[j],
      width: across[i + 1] - across[i],
      height: down[j + 1] - down[j],
    };
  });
}

/** `first`, the midpoints between neighbours, and `reach` beyond the last value. */
function middles(at: number[], first: number, reach: number): number[] {
  const between = at.slice(1).map((x, i) => (x + at[i]) / 2);
  return [first, ...between, (at.at(-1) ?? 0) + reach];
}
