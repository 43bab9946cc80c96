// What the triangles of a file belong to.

/** An object of a scene, or a material. */
export interface NamedPart {
  /** '' if it has none. */
  name: string;
  /** Not so for what has no material. */
  isThere: boolean;
  /** How often the scene has it, with the same texels. */
  copies: number;
  /** Triangles that follow each other: the first, and how many. */
  runs: [first: number, count: number][];
}

export interface NamedParts {
  objects: NamedPart[];
  materials: NamedPart[];
}

export const NO_PARTS: NamedParts = { objects: [], materials: [] };
