// What the browser keeps of a visit: the mesh as it was opened, and what was asked for.

import type { UnwrapResult, VertexBound } from 'abflat';
import type { FileSource, Outcome, Source } from '../model/model';
import type { KnownAtlas, Marks, Settings } from '../model/settings';
import { staysInPlace } from '../session/stays-in-place';
import { settingsOf, textOf } from './settings-text';

export type KeptMesh =
  | { kind: 'sample'; name: string }
  | Pick<FileSource, 'kind' | 'name' | 'file' | 'others' | 'texcoord'>;

export interface Asked {
  /** The settings as they are in a link. */
  text: string;
  /** Seams that were edited. */
  edited?: { seams: string; seamEdges: Uint32Array };
  /** Of vertices of a boundary. */
  bounds?: VertexBound[];
  /** The layout, where the settings alone would not lead to it again. */
  atlas?: KnownAtlas;
  /** Charts of it. */
  locked?: Uint32Array;
  /** Per face, its texel density relative to the others. */
  densities?: Float32Array;
  /** Pinned corners. */
  pins?: Uint32Array;
  /** The UVs of a file that were changed by hand. */
  uv?: Float64Array;
}

export interface Visit {
  source: Source;
  asked: Asked;
}

export function meshOf(source: Source): KeptMesh {
  if (source.kind === 'sample') return source;
  const { kind, name, file, others, texcoord } = source;
  return { kind, name, file, others, texcoord };
}

export const bytesOf = (mesh: KeptMesh): number =>
  mesh.kind === 'sample' ? 0 : [mesh.file, ...mesh.others].reduce((sum, { size }) => sum + size, 0);

/** `marks`: what is locked and pinned now. */
export function askedOf(outcome: Outcome, { kept, pins }: Marks): Asked {
  const asked: Asked = { text: textOf(outcome.settings) };
  if (outcome.mode === 'flatten') {
    const { bounds } = outcome.settings;
    return bounds ? { ...asked, bounds } : asked;
  }
  if (outcome.mode === 'pack') {
    const { uv } = outcome.settings;
    return uv ? { ...asked, uv } : asked;
  }
  const { result, settings } = outcome;
  if (pins) asked.pins = pins;
  if (settings.faceDensities) asked.densities = settings.faceDensities;
  const { seams, seamEdges, placed, stack } = settings;
  const isStackedByHand = stack === 'none' && outcome.stacks !== undefined;
  if (seamEdges) asked.edited = { seams, seamEdges };
  const locked = kept?.layout === result ? kept.charts : new Uint32Array();
  const isOwn =
    Boolean(seamEdges ?? placed) || isStackedByHand || locked.length > 0 || staysInPlace(outcome);
  // A chart that is not valid, and was not moved, cannot be kept in its place.
  if (!isOwn || !(result.report.valid || staysInPlace(outcome))) return asked;
  return { ...asked, atlas: atlasOf(result), locked };
}

function atlasOf(result: UnwrapResult): KnownAtlas {
  const { uv, unpacked, indices, vertexMap, chartOfTriangle, seams, report } = result;
  const { t, straightSeams, balance } = report.options;
  const options = { t, straightSeams, balance };
  return { uv, unpacked, indices, vertexMap, chartOfTriangle, seams, report: { options } };
}

/** Throws if these values are not those of a visit. */
export function visitOf(mesh: unknown, asked: unknown): Visit {
  if (typeof (asked as Asked | undefined)?.text !== 'string') throw new Error('no settings');
  return { source: sourceOf(mesh as KeptMesh), asked: asked as Asked };
}

function sourceOf(mesh: KeptMesh): Source {
  if (mesh?.kind === 'sample') return { kind: 'sample', name: String(mesh.name) };
  const { kind, name, file, others, texcoord } = mesh;
  if (![file, ...others].every((each) => each instanceof File)) throw new Error('no files');
  const source: FileSource = { kind, name: String(name), file, others, together: [], texcoord };
  source.together.push(source);
  return source;
}

export function settingsAskedFor(asked: Asked): Settings {
  const { text, edited, bounds, atlas, locked, pins, densities, uv } = asked;
  const { settings } = settingsOf(text);
  if (settings.mode === 'flatten') return bounds ? { ...settings, bounds } : settings;
  if (settings.mode === 'pack') return uv ? { ...settings, uv } : settings;
  const kept = atlas && locked && { kept: { layout: atlas, charts: locked } };
  const placed = atlas && { placed: atlas };
  const byHand = { ...(pins && { pins }), ...(densities && { faceDensities: densities }) };
  return { ...settings, ...edited, ...placed, ...kept, ...byHand };
}
