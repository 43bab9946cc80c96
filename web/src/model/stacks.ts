import type { UnwrapReport } from 'abflat';

/** Charts that lie on each other with the same outline, so that they share their texels. */
export type Stack = number[];

export interface Stacks {
  stacks: Stack[];
  /** Area in uv of all but the lowest chart of each. */
  repeated: number;
}

/** The islands of a file that lie on each other on purpose. */
export interface FileStacks {
  stacks: Stack[];
  /** Those of the file, with STACKED in place of `overlapping` in stacks. */
  faults: Uint8Array;
  /** With a triangle that is stacked. */
  faces: number;
}

/** Those that abflat has made or found, where equal charts are to be stacked; undefined if there are none. */
export function stacksIn({ charts }: UnwrapReport): Stack[] | undefined {
  const stacks = new Map<number, Stack>();
  for (const [chart, { stackedOn }] of charts.entries()) {
    if (stackedOn < 0) continue;
    if (!stacks.has(stackedOn)) stacks.set(stackedOn, [stackedOn]);
    stacks.get(stackedOn)?.push(chart);
  }
  return stacks.size > 0 ? [...stacks.values()] : undefined;
}

/** Charts and all that lie with them in a stack. */
export function withStacks(charts: Uint32Array, stacks: Stack[] = []): Uint32Array {
  const out = new Set(charts);
  for (const stack of stacks)
    if (stack.some((chart) => out.has(chart))) for (const chart of stack) out.add(chart);
  return Uint32Array.from(out);
}

/** How many charts share their texels with others. */
export const stackedCharts = (stacks: Stack[] = []): number => stacks.flat().length;
