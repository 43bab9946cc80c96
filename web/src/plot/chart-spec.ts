import type { Scale } from './scale';

/** How a value is drawn, and which class it has in the style sheet. */
export type Shape = 'filled' | 'hollow' | 'diamond';

export interface Mark {
  x: number;
  y: number;
}

export interface Series {
  /** For the legend and the table. */
  name: string;
  /** Which of the chart's colours. */
  color: 'first' | 'second' | 'third';
  shape: Shape;
  hasLine: boolean;
  marks: Mark[];
}

/** What is under the pointer or has the focus: all at one x, or the part of it that is nearest to y. */
export interface Column {
  x: number;
  y?: number;
  /** Read out. */
  text: string;
  /** Called on click, Enter and Space. */
  select?: () => void;
}

export interface Table {
  head: string[];
  rows: string[][];
}

/** A chart as plain values. */
export interface ChartSpec {
  title: string;
  /** For those who do not see it. */
  description: string;
  /** Under the axis; empty when that is clear. */
  xName: string;
  x: Scale;
  y: Scale;
  series: Series[];
  /** Ascending in x. */
  columns: Column[];
  /** A line across the chart at this x. */
  current?: number;
  table: Table;
}
