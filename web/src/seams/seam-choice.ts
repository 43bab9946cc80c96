import type { MeshSummary } from 'abflat';

/** Where seams come from, in the words of the command line. */
export interface SeamSources {
  auto: boolean;
  /** Along edges where the shading of the file breaks. */
  hard: boolean;
  uv: boolean;
  material: boolean;
  /** Degrees; null: not along sharp edges. */
  sharp: number | null;
}

/** The cuts that the user wants. */
export interface SeamChoice {
  sources: SeamSources;
  /** Two vertices per edge; these replace the seams of the sources. */
  edges: Uint32Array | null;
  /** Automatic seams in addition to `edges`. */
  isCutFurther?: boolean;
}

export const AUTOMATIC: SeamChoice = {
  sources: { auto: true, hard: false, uv: false, material: false, sharp: null },
  edges: null,
};

/** What the open mesh can be cut along. */
export interface Offered {
  hard: boolean;
  uv: boolean;
  material: boolean;
}

export const offeredBy = (summary: MeshSummary): Offered => ({
  hard: summary.normals > 0 || summary.smoothingGroups > 0,
  uv: summary.texcoords > 0,
  material: summary.materials > 1,
});

/** The value of `--seams`. */
export function seamWords({ auto, hard, uv, material, sharp }: SeamSources): string {
  const words = [
    ...(auto ? ['auto'] : []),
    ...(hard ? ['hard'] : []),
    ...(uv ? ['uv'] : []),
    ...(material ? ['material'] : []),
    ...(sharp !== null ? [`sharp=${sharp}`] : []),
  ];
  return words.join(',') || 'none';
}

export interface SeamOptions {
  seams: string;
  seamEdges?: Uint32Array;
}

/** The choice that has these options. */
export function choiceOf({ seams, seamEdges }: SeamOptions): SeamChoice {
  const words = seams.split(',');
  if (seamEdges) return { ...AUTOMATIC, edges: seamEdges, isCutFurther: words.includes('auto') };
  const sharp = words.find((word) => word.startsWith('sharp='));
  const sources = {
    auto: words.includes('auto'),
    hard: words.includes('hard'),
    uv: words.includes('uv'),
    material: words.includes('material'),
    sharp: sharp ? Number(sharp.slice('sharp='.length)) : null,
  };
  return { sources, edges: null };
}

/** As options of `unwrap`. */
export function seamOptions({ sources, edges, isCutFurther }: SeamChoice): SeamOptions {
  if (!edges) return { seams: seamWords(sources) };
  return { seams: isCutFurther ? 'auto' : 'none', seamEdges: edges };
}
