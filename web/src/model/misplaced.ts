// How abflat says that a chart of an atlas is in the wrong place.

const OUTSIDE = /it extends beyond its tile/;
const OVERLAPPING = /it touches or overlaps the chart/;

export const isOutside = (problem: string) => OUTSIDE.test(problem);
export const isOverlapping = (problem: string) => OVERLAPPING.test(problem);
