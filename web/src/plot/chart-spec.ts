import type { Scale } from './scale';

/** How a value is drawn; also its class in the style sheet. */
export type Shape = 'filled' | 'hollow' | 'diamond';

export interface Mark {
  x: number;
  y: number;
}

export interface Series {
  /** For the legend and the table. */
  name: string;
  /** Which of the chart's colours to use. */
  color: 'first' | 'second' | 'third';
  shape: Shape;
  hasLine: boolean;
  marks: Mark[];
}

/**
 * What is under the pointer or has the focus: everything at one x, or the part of it that is
 * nearest to y.
 */
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
  /** For people who do not see the chart. */
  description: string;
  /** Shown under the axis; empty if it goes without saying. */
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
