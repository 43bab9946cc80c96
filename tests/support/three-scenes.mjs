// Scenes of three.js, and what is drawn of them.

import * as THREE from 'three';

/** 6 x 5 meshes that stand on a floor and touch each other, of 8 geometries, some of them shared. */
export function yard() {
  const scene = new THREE.Scene();
  const material = new THREE.MeshStandardMaterial();
  const shapes = [
    new THREE.BoxGeometry(1, 1, 1),
    new THREE.SphereGeometry(0.5, 12, 8),
    new THREE.CylinderGeometry(0.5, 0.5, 1, 12),
    new THREE.TorusGeometry(0.35, 0.15, 8, 12),
    new THREE.ConeGeometry(0.5, 1, 10).toNonIndexed(),
    new THREE.CapsuleGeometry(0.25, 0.5, 4, 10),
    new THREE.IcosahedronGeometry(0.5, 1),
    new THREE.PlaneGeometry(1, 1, 2, 2),
  ];
  for (let i = 0; i < 30; ++i) {
    const mesh = new THREE.Mesh(shapes[i % 8], material);
    mesh.name = `mesh ${i}`;
    // Cells of a grid, so that boxes have whole faces in common.
    mesh.position.set(i % 6, 0.5, Math.floor(i / 6));
    scene.add(mesh);
  }
  const at = (i) => scene.children[i];
  at(1).scale.set(1, 2, 1);
  at(2).scale.x = -1;
  at(3).rotation.set(1, 2, 3);
  at(9).scale.set(-1, -1, -1);
  at(10).scale.setScalar(0.3);
  at(12).rotation.set(0.3, 0, -1);
  at(13).scale.set(1, -2.5, 0.5);
  at(20).scale.set(2, 1, 0.5);
  at(25).scale.set(-3, 3, 3);
  // Two boxes side by side, two in one place, and a pair in a group that is itself turned, mirrored and scaled.
  at(24).position.set(1, 0.5, 0);
  at(16).position.copy(at(8).position);
  const group = new THREE.Group();
  group.position.set(-4, 1, 0);
  group.rotation.y = 1;
  group.scale.set(1.5, 1.5, -1.5);
  scene.add(group);
  group.add(at(29), at(28));
  return scene;
}

const toArray = (attribute, i, size) =>
  [attribute.getX(i), attribute.getY(i), attribute.getZ(i)].slice(0, size);

/** Triangles `{ object, places, uv }` that a mesh draws in the world, once for each instance. */
export function trianglesOf(mesh, attribute = 'uv1', geometry = mesh.geometry) {
  const { position, [attribute]: uv } = geometry.attributes;
  const { index, drawRange } = geometry;
  const count = index?.count ?? position.count;
  const end = Math.min(count, drawRange.start + drawRange.count);
  mesh.updateWorldMatrix(true, false);
  const matrices = mesh.isInstancedMesh
    ? Array.from({ length: mesh.count }, (_, i) => {
        const own = new THREE.Matrix4();
        mesh.getMatrixAt(i, own);
        return own.premultiply(mesh.matrixWorld);
      })
    : [mesh.isSkinnedMesh ? new THREE.Matrix4() : mesh.matrixWorld];
  return matrices.flatMap((matrix, instance) => {
    const triangles = [];
    for (let c = drawRange.start; c + 2 < end; c += 3) {
      const corners = [0, 1, 2].map((k) => index?.getX(c + k) ?? c + k);
      if (matrix.determinant() < 0) corners.reverse();
      triangles.push({
        object: mesh.isInstancedMesh ? `${mesh.name} ${instance}` : mesh.name,
        places: corners
          .map((v) => new THREE.Vector3().fromBufferAttribute(position, v))
          .map((point) => point.applyMatrix4(matrix).toArray()),
        uv: uv ? corners.map((v) => toArray(uv, v, 2)) : undefined,
      });
    }
    return triangles;
  });
}

export function meshesBelow(object) {
  const meshes = [];
  object.traverseVisible((child) => {
    if (child.isMesh) meshes.push(child);
  });
  return meshes;
}
