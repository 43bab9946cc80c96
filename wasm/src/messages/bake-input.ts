// Checks the mesh and the layout that callers pass to bake, and copies them.

import { AbflatError } from '../base/errors.js';
import { fieldsOf, ownFields } from './fields.js';
import { checkLength, checkMultiple, reals, take, takeArrays, whole } from './input.js';
import type { BakeArrays, BakeRequest } from './protocol.js';
import { tagOf } from './validate.js';

const invalidMesh = (message: string) => new AbflatError('InvalidMesh', message);

/** The mesh in arrays of its own. */
export function takeBakeMesh(mesh: unknown): BakeArrays {
  if (tagOf(mesh) !== 'Object')
    throw invalidMesh('The mesh must be { positions, indices, texcoords }.');
  const { colours, tangents, parts } = fieldsOf(mesh, ['colours', 'tangents', 'parts']);
  const given = ownFields(takeArrays(mesh, false, { take }).mesh);
  const { positions, indices, texcoords, normals, materials } = given;
  if (!texcoords)
    throw invalidMesh('The mesh has no texcoords, so nothing says where its old images are.');
  const out: BakeArrays = { positions, indices, texcoords };
  if (normals) out.normals = normals;
  if (materials) out.materials = materials;
  for (const [name, values] of Object.entries({ colours, tangents })) {
    if (values === undefined) continue;
    const array = new Float64Array(reals(name, values));
    checkLength(name, array, (4 * positions.length) / 3, '4 per vertex');
    Object.assign(out, { [name]: array });
  }
  if (parts !== undefined) {
    out.parts = new Uint32Array(whole('parts', parts));
    checkLength('parts', out.parts, indices.length / 3, '1 per triangle');
  }
  return out;
}

/** The layout in arrays of its own. */
export function takeBakeLayout(layout: unknown, mesh: BakeArrays): BakeRequest['layout'] {
  if (tagOf(layout) !== 'Object')
    throw invalidMesh('The layout must be { uv, indices, vertexMap }, such as a result of unwrap.');
  const given = fieldsOf(layout, ['uv', 'indices', 'vertexMap']);
  const uv = new Float64Array(reals('uv', given.uv));
  checkMultiple('uv', uv, 2);
  const indices = new Uint32Array(
    given.indices === undefined ? mesh.indices : whole('The indices of the layout', given.indices),
  );
  checkLength('The indices of the layout', indices, mesh.indices.length, '3 per triangle');
  if (given.vertexMap === undefined) return { uv, indices };
  const vertexMap = new Uint32Array(whole('vertexMap', given.vertexMap));
  checkLength('vertexMap', vertexMap, uv.length / 2, '1 per vertex of the layout');
  return { uv, indices, vertexMap };
}
