// Things in a courtyard. Some share a geometry, are mirrored or scaled, and most touch others.

import * as THREE from 'three';

const material = (color) => new THREE.MeshStandardMaterial({ color });

function add(scene, name, geometry, color, place) {
  const mesh = new THREE.Mesh(geometry, material(color));
  mesh.name = name;
  place(mesh);
  scene.add(mesh);
}

export function courtyard() {
  const scene = new THREE.Scene();
  const box = new THREE.BoxGeometry();
  add(scene, 'floor', new THREE.PlaneGeometry(8, 8), '#c8bfae', (mesh) =>
    mesh.rotateX(-Math.PI / 2),
  );
  add(scene, 'wall at the back', box, '#d9d2c5', (mesh) => {
    mesh.scale.set(8, 3, 0.2);
    mesh.position.set(0, 1.5, -4.1);
  });
  add(scene, 'wall at the left', box, '#d9d2c5', (mesh) => {
    mesh.scale.set(0.2, 3, 8);
    mesh.position.set(-4.1, 1.5, 0);
  });
  for (const [i, [x, y, z]] of [
    [-2, 0.5, -2],
    [-1, 0.5, -2],
    [-1.5, 1.5, -2],
  ].entries())
    add(scene, `box ${i}`, box, '#b5673c', (mesh) => mesh.position.set(x, y, z));
  add(scene, 'ball', new THREE.SphereGeometry(0.8, 32, 20), '#7fa3b8', (mesh) =>
    mesh.position.set(1.6, 0.8, -1.4),
  );
  add(scene, 'knot', new THREE.TorusKnotGeometry(0.55, 0.18, 120, 14), '#8f9b54', (mesh) =>
    mesh.position.set(-1.8, 1, 1.4),
  );
  const column = new THREE.CylinderGeometry(0.3, 0.4, 2.4, 24);
  for (const x of [0.6, 2.6])
    add(scene, `column ${x}`, column, '#e3ddd2', (mesh) => mesh.position.set(x, 1.2, 1));
  add(scene, 'beam', box, '#e3ddd2', (mesh) => {
    mesh.scale.set(-3, 0.3, 0.8); // mirrored
    mesh.position.set(1.6, 2.55, 1);
  });
  add(scene, 'capsule', new THREE.CapsuleGeometry(0.3, 0.8, 6, 20), '#a0526a', (mesh) => {
    mesh.position.set(0.1, 0.3, 2.6);
    mesh.rotation.set(Math.PI / 2, 0, 0.6);
  });
  return scene;
}
