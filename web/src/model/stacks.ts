/** Charts that lie on each other with the same outline, so that they share their texels. */
export type Stack = number[];

export interface Stacks {
  stacks: Stack[];
  /** Area in uv of all but the lowest chart of each. */
  repeated: number;
}

/** How many charts share their texels with others. */
export const stackedCharts = (stacks: Stack[] = []): number => stacks.flat().length;
