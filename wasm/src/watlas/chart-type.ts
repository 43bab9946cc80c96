/** The kinds of charts of xatlas. Those of abflat are of the nearest one, LSCM. */
export const ChartType = { Planar: 0, Ortho: 1, LSCM: 2, Piecewise: 3, Invalid: 4 } as const;

export type ChartType = (typeof ChartType)[keyof typeof ChartType];
