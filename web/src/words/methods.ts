// The table of methods.

/** The columns of the methods' table. */
export const METHOD_COLUMNS = {
  time: { name: 'Time', title: 'Time for the layout only' },
  angle: { name: 'Angle', title: 'Angular distortion: mean over corners of ((x - α)/α)²' },
  length: { name: 'Length', title: 'Length distortion: mean over edges of (sL/l - 1)²' },
  area: {
    name: 'Area',
    title: 'Area distortion: mean by 3D area of |log(area in the layout / area in 3D)|',
  },
  flips: { name: 'Flips', title: 'Flipped triangles' },
  crossings: { name: 'Cross.', title: 'Pairs of boundary edges that cross or touch' },
};
