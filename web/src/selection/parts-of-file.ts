import type { Arrangeable } from '../model/arrangeable';
import type { NamedPart } from '../model/named-parts';
import type { Workshop } from '../workshop/workshop';

export type PartKind = 'material' | 'group';

/**
 * The number of each triangle's material, or of its object or group, by the file; null if the file
 * has none of the kind. Without named groups, those are connected parts.
 */
export async function partsOfFile(
  outcome: Arrangeable,
  kind: PartKind,
  workshop: Pick<Workshop, 'namedParts' | 'connectedParts'>,
): Promise<ArrayLike<number> | null> {
  const { mesh } = outcome;
  const { objects, materials } = await workshop.namedParts(outcome);
  const parts = kind === 'material' ? materials : objects;
  if (parts.length > 1) return numbersOf(parts, mesh.indices.length / 3);
  return kind === 'group' ? workshop.connectedParts(mesh) : null;
}

function numbersOf(parts: NamedPart[], triangles: number): Uint32Array {
  const numbers = new Uint32Array(triangles);
  parts.forEach(({ runs }, number) => {
    for (const [first, count] of runs) numbers.fill(number, first, first + count);
  });
  return numbers;
}
