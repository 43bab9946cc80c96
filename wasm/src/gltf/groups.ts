// Which primitives share an atlas, and the calls that make the atlases.

import type { Mesh, Primitive } from '@gltf-transform/core';
import { AbflatError } from '../base/errors.js';
import { areaOf } from '../base/placement.js';
import { shown } from '../messages/validate.js';
import type { DocumentMesh, DocumentPart, Member } from './document-mesh.js';

/**
 * What shares an atlas: everything, the primitives of a mesh, or nothing (one atlas per primitive).
 */
export type GroupBy = 'scene' | 'mesh' | 'primitive';

const WAYS = ['scene', 'mesh', 'primitive'] as const satisfies GroupBy[];

const invalid = (message: string) => new AbflatError('InvalidOption', message);

export function checkGroupBy(groupBy: unknown): void {
  if (!WAYS.includes(groupBy as GroupBy))
    throw invalid(`groupBy must be one of ${WAYS.join(', ')}, not ${shown(groupBy)}.`);
}

/** The sets to read and to write. */
export function checkSets(texcoord: unknown, readTexcoord: unknown): void {
  const isSet = (set: unknown) => Number.isInteger(set) && (set as number) >= 0;
  if (texcoord !== 'auto' && !isSet(texcoord))
    throw invalid(`texcoord must be 'auto' or a whole number from 0, not ${shown(texcoord)}.`);
  if (!isSet(readTexcoord))
    throw invalid(`readTexcoord must be a whole number from 0, not ${shown(readTexcoord)}.`);
}

export function grouped(members: Member[], groupBy: GroupBy): Member[][] {
  const groups = new Map<Mesh | Primitive | undefined, Member[]>();
  for (const member of members) {
    const key = groupBy === 'scene' ? undefined : member[groupBy];
    const group = groups.get(key) ?? [];
    group.push(member);
    groups.set(key, group);
  }
  return [...groups.values()];
}

/** Meshes with their share of the room on pages. `sizeOf`: that of a surface. */
export function sizedMeshes(
  { positions, indices, parts }: DocumentMesh,
  sizeOf: (part: DocumentPart, area: number) => number,
): { thing: Mesh; size: number }[] {
  const sizes = new Map<Mesh, number>();
  for (const part of parts) {
    const first = 3 * part.firstTriangle;
    const area = areaOf(positions, indices.subarray(first, first + 3 * part.triangleCount));
    sizes.set(part.mesh, (sizes.get(part.mesh) ?? 0) + sizeOf(part, area));
  }
  return [...sizes].map(([thing, size]) => ({ thing, size }));
}

type Listener<P> = ((progress: P) => void) | undefined;

/** What a call for one atlas takes besides the options of its kind. */
export interface CallOfAtlas<P> {
  onProgress?: (progress: P) => void;
  transfer: true;
  roundsForGltf: true;
}

/** Calls `lay` for one mesh after the other; `fraction` covers all of them. */
export async function layEach<P extends { fraction: number }, R>(
  meshes: DocumentMesh[],
  onProgress: Listener<P>,
  lay: (mesh: DocumentMesh, call: CallOfAtlas<P>, i: number) => Promise<R>,
): Promise<{ parts: DocumentPart[]; result: R }[]> {
  const atlases: { parts: DocumentPart[]; result: R }[] = [];
  for (const [i, mesh] of meshes.entries()) {
    const tell = (progress: P) =>
      onProgress?.({ ...progress, fraction: (i + progress.fraction) / meshes.length });
    const result = await lay(
      mesh,
      {
        ...(onProgress && { onProgress: tell }),
        transfer: true,
        roundsForGltf: true,
      },
      i,
    );
    atlases.push({ parts: mesh.parts, result });
  }
  return atlases;
}
