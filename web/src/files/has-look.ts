import { isGlb, meshFileOf } from '../base/mesh-files';
import type { GltfFiles } from '../model/model';

/** What colours a glTF. */
const GLTF_COLOR = /"(COLOR_0|(baseColor|diffuse)(Texture|Factor))"/;
/** Names of colours in the header of a PLY. */
const PLY_COLOR = /^property\s+\w+\s+(red|diffuse_red|r)\s*$/m;
/** "v x y z r g b" */
const COLORED_VERTEX = /^v(?:[ \t]+[-+.\deE]+){6}[ \t]*(?:#|\r?$)/m;
/** Bytes that a file begins with. */
const BEGINNING = 1 << 16;

/** Whether a file may have more than a shape: only then, what reads it is loaded. */
export async function hasLook(file: File, gltf: GltfFiles | undefined): Promise<boolean> {
  if (gltf) return GLTF_COLOR.test(await jsonOf(gltf.file));
  const format = meshFileOf(file.name)?.format;
  if (format === 'ply') return hasColors(file);
  if (format !== 'obj') return false;
  const text = await file.text();
  return text.includes('usemtl') || COLORED_VERTEX.test(text);
}

/** Whether the first vertices of a PLY or an OBJ have colours. */
export async function hasColors(file: File): Promise<boolean> {
  const format = meshFileOf(file.name)?.format;
  if (format !== 'ply' && format !== 'obj') return false;
  const text = await file.slice(0, BEGINNING).text();
  return (format === 'ply' ? PLY_COLOR : COLORED_VERTEX).test(text);
}

/** Of a GLB, its first chunk. */
async function jsonOf(file: File): Promise<string> {
  const head = new DataView(await file.slice(0, 20).arrayBuffer());
  const isBinary = head.byteLength === 20 && isGlb(new Uint8Array(head.buffer));
  return (isBinary ? file.slice(20, 20 + head.getUint32(12, true)) : file).text();
}
