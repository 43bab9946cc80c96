import { boundingBox, type DisplayMesh, usedVertices } from '../mesh/mesh';
import { outlines } from '../mesh/outlines';
import { sideBySide } from './side-by-side';

export interface NamedMesh extends DisplayMesh {
  name: string;
}

/** The meshes as one OBJ, each an object with its name, side by side. Their faces stay polygons. */
export function joinedObj(meshes: NamedMesh[]): string[] {
  const parts: string[] = [];
  let before = 1;
  const moves = sideBySide(meshes.map(boxOf));
  for (const [i, mesh] of meshes.entries()) {
    const { name, positions } = mesh;
    parts.push(`o ${oneLine(name)}\n`, verticesOf(positions, moves[i]), facesOf(mesh, before));
    before += positions.length / 3;
  }
  return parts;
}

const oneLine = (name: string) => name.replace(/\s+/g, ' ').trim();

const boxOf = ({ positions, indices }: DisplayMesh) =>
  boundingBox(positions, 3, usedVertices(positions.length / 3, indices));

function verticesOf(positions: Float64Array, moved: number): string {
  const lines: string[] = [];
  for (let i = 0; i < positions.length; i += 3)
    lines.push(`v ${positions[i] + moved} ${positions[i + 1]} ${positions[i + 2]}\n`);
  return lines.join('');
}

function facesOf(mesh: DisplayMesh, before: number): string {
  const lines: string[] = [];
  for (const outline of outlines(mesh))
    lines.push(`f ${outline.map((v) => v + before).join(' ')}\n`);
  return lines.join('');
}
