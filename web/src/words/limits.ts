// What a file loses in another format.

const NAMES: Record<string, string> = {
  materials: 'materials',
  names: 'names',
  skins: 'skins',
  morphTargets: 'morph targets',
  animations: 'animations',
  // Of an FBX.
  polygons: 'polygons',
  maps: 'some textures',
  morphAnimations: 'animations of morph targets',
  cameras: 'cameras',
  lights: 'lights',
  curves: 'curves',
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
