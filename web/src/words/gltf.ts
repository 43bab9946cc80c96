// Files of glTF that are read and written.

import { count, ended } from './format';

/** Why a glTF or GLB cannot be read or written. */
export const GLTF = {
  needs: (name: string, wanted: string | undefined) =>
    `${name} needs ${wanted}: open or drop both files together.`,
  truncated: (name: string, there: number, length: number) =>
    `${name} is truncated: it has only ${count(there)} of ${count(length)} bytes. Copy or download it again.`,
  unknownExtension: (name: string, extension: string) =>
    `${name} requires ${extension}, which this page cannot read. Save it without that extension.`,
  otherVersion: (name: string) => `${name} is not glTF 2.0. Save it as glTF 2.0 or GLB.`,
  /** `reason` is a sentence of the browser. */
  notJson: (name: string, reason: string) =>
    `${name} is not a glTF file, because it is not valid JSON: ${ended(reason)} Export or download it again.`,
  notGlb: (name: string) =>
    `${name} is not a GLB file, because it does not begin with "glTF". Export or download it again.`,
  noTriangles: (name: string) => `${name} has no triangles, so there is nothing to unwrap.`,
  damaged: (name: string, reason: string) =>
    `${name} is damaged or too large to read (${reason}). Export or download it again.`,
  undecodable: (name: string, compressions: string[], reason: string) =>
    `${name} is damaged: its ${compressions.join(' and ')} data cannot be decoded (${reason}). Export or download it again.`,
  compressed: (name: string, compressions: string[]) =>
    `${name} was compressed with ${compressions.join(' and ')}. The export is uncompressed.`,
  attributeMissing: 'an attribute is missing',
  senselessView: (view: number) => `buffer view ${view} is invalid`,
  tooLarge: 'Its coordinates are too large for GLB. Scale the mesh down, or choose OBJ',
};
