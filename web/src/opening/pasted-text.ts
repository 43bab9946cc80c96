// What a text from the clipboard is.

import { MESH_FILES } from '../words/generated-formats';

export type Pasted = { kind: 'address'; text: string } | { kind: 'mesh'; name: string };

/** Bytes that tell what it is. */
const START = 4096;
const ADDRESS = /^https?:\/\/\S+$/i;

const OBJ_LINE = /^(?:v|vt|vn|vp|f|l|o|g|s|mtllib|usemtl)\s/;
const OBJ_VERTEX = /^v(?:\s+[-+.\d][-+.\deE]*){3,}\s*$/;

/** Null for any other text. */
export function pastedIn(text: string): Pasted | null {
  const start = text.slice(0, START).trimStart();
  const line = text.length < START ? start.trim() : '';
  if (ADDRESS.test(line)) return { kind: 'address', text: line };
  const file = MESH_FILES.find(({ pasted }) => pasted?.test(start));
  if (file) return { kind: 'mesh', name: `pasted${file.ending}` };
  return beginsLikeObj(start) ? { kind: 'mesh', name: 'pasted.obj' } : null;
}

/** The last line may be cut off. */
function beginsLikeObj(start: string): boolean {
  const lines = start.split(/\r?\n/).slice(0, -1);
  const said = lines.map((line) => line.trim()).filter((line) => line && !line.startsWith('#'));
  return said.every((line) => OBJ_LINE.test(line)) && said.some((line) => OBJ_VERTEX.test(line));
}
