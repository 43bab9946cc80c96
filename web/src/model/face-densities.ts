/** What faces ask for: texel densities relative to each other, one per face. Undefined: 1 each. */
export type FaceDensities = Float32Array | undefined;

/** That of the package. */
export const DENSITY_RULE = { type: 'number', atLeast: 1e-3, atMost: 1e3 };
