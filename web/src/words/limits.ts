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
  notBaked: 'shape and UVs only, no baked textures',
  /** By abflat's names; '' for none. */
  loses: (lost: string[]) => {
    if (lost.length === 0) return '';
    const names = lost.map((each) => NAMES[each]);
    const [last, ...others] = names.reverse();
    return `loses ${others.length > 0 ? `${others.reverse().join(', ')} and ${last}` : last}`;
  },
};
