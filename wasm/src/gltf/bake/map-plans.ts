// Which maps some materials need, and what each takes from them.

import { MAPS, type MapName, type MaterialLook } from './material-look.js';

type Factor = [number, number, number, number];

export interface MapPlan {
  name: MapName;
  kind: 'colour' | 'data' | 'normal';
  /** By material, as in BakeSource. */
  factors: Factor[];
}

export interface MapPlans {
  plans: MapPlan[];
  /** What the emissive map is to be multiplied by. */
  emissiveStrength: number;
}

const KINDS = {
  baseColor: 'colour',
  metallicRoughness: 'data',
  occlusion: 'data',
  normal: 'normal',
  emissive: 'colour',
} as const satisfies Record<MapName, MapPlan['kind']>;

/**
 * Those that one of the materials has a texture for, or that are more than one number for all, as
 * the base colour is where vertices have colours.
 */
export function planMaps(looks: readonly MaterialLook[], hasVertexColours: boolean): MapPlans {
  const emissiveStrength = Math.max(1, ...looks.flatMap(({ emission }) => emission));
  const plans = MAPS.map((name) => {
    const factors = looks.map((look) => factorOf(name, look, emissiveStrength));
    return { name, kind: KINDS[name], factors };
  });
  const isWanted = (plan: MapPlan) =>
    isNeeded(plan, looks) || (hasVertexColours && plan.name === 'baseColor');
  return { plans: plans.filter(isWanted), emissiveStrength };
}

function factorOf(name: MapName, look: MaterialLook, emissiveStrength: number): Factor {
  const [red = 1, green = 1, blue = 1, alpha = 1] = look.baseColor;
  const [r = 0, g = 0, b = 0] = look.emission.map((x) => x / emissiveStrength);
  switch (name) {
    case 'baseColor':
      return [red, green, blue, look.isOpaque ? 1 : alpha];
    case 'metallicRoughness':
      return [1, look.roughness, look.metallic, 1];
    case 'occlusion': // its strength is part of its image
      return [1, 1, 1, 1];
    case 'normal':
      return [look.normalScale, look.normalScale, 1, 1];
    case 'emissive':
      return [r, g, b, 1];
  }
}

function isNeeded({ name, factors }: MapPlan, looks: readonly MaterialLook[]): boolean {
  if (looks.some(({ textures }) => textures[name])) return true;
  // Without a texture the scale of a normal map means nothing.
  return name !== 'normal' && factors.some((factor) => factor.join() !== factors[0]?.join());
}
