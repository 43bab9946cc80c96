import type { DisplayMesh } from '../mesh/mesh';
import { outlines } from '../mesh/outlines';

export interface NamedMesh extends DisplayMesh {
  name: string;
}

/** The meshes as one OBJ, each an object with its name. Their faces stay polygons. */
export function joinedObj(meshes: NamedMesh[]): string[] {
  const parts: string[] = [];
  let before = 1;
  for (const mesh of meshes) {
    const { name, positions } = mesh;
    parts.push(`o ${oneLine(name)}\n`, verticesOf(positions), facesOf(mesh, before));
    before += positions.length / 3;
  }
  return parts;
}

const oneLine = (name: string) => name.replace(/\s+/g, ' ').trim();

function verticesOf(positions: Float64Array): string {
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3)
    lines.push(`v ${positions[i]} ${positions[i + 1]} ${positions[i + 2]}\n`);
  return lines.join('');
}

function facesOf(mesh: DisplayMesh, before: number): string {
  const lines: string[] = [];
  for (const outline of outlines(mesh))
    lines.push(`f ${outline.map((v) => v + before).join(' ')}\n`);
  return lines.join('');
}
