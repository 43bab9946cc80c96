/** The box around a mesh. */
export interface Box {
  min: readonly number[];
  max: readonly number[];
}

/** Relative to the widest. */
const GAP = 0.1;
/** Of the lowest one. A head above a body has less of its height in common with it. */
const SHARED_HEIGHT = 0.5;

/**
 * How far to move each along x. Things that are each modelled around the origin would lie in each
 * other, so they go side by side. Anything else may be parts of one scene, and stays where it is.
 */
export function sideBySide(boxes: readonly Box[]): number[] {
  if (!boxes.every(isAroundOrigin) || !areAlongside(boxes)) return boxes.map(() => 0);
  const widths = boxes.map(({ min, max }) => max[0] - min[0]);
  const gap = GAP * Math.max(...widths);
  let left = boxes[0].min[0];
  return boxes.map(({ min }, i) => {
    const by = i > 0 ? left - min[0] : 0;
    left += widths[i] + gap;
    return by;
  });
}

const isAroundOrigin = ({ min, max }: Box) =>
  [...min, ...max].every(Number.isFinite) && [0, 2].every((d) => min[d] <= 0 && max[d] >= 0);

function areAlongside(boxes: readonly Box[]): boolean {
  const low = Math.max(...boxes.map(({ min }) => min[1]));
  const high = Math.min(...boxes.map(({ max }) => max[1]));
  const lowest = Math.min(...boxes.map(({ min, max }) => max[1] - min[1]));
  return high - low >= SHARED_HEIGHT * lowest;
}
