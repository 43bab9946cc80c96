// What a file loses in another format.

const NAMES: Record<string, string> = {
  materials: 'materials',
  names: 'names',
  skins: 'skins',
  morphTargets: 'morph targets',
  animations: 'animations',
};

export const LIMITS = {
  shapeOnly: 'shape and UVs only',
  /** One or more, by abflat's names. */
  loses: (lost: string[]) => {
    const names = lost.map((each) => NAMES[each]);
    const [last, ...others] = names.reverse();
    return `loses ${others.length > 0 ? `${others.reverse().join(', ')} and ${last}` : last}`;
  },
};
