// Runs in a page: draws GLB files and compares the pictures.

import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const SIDE = 320;

/** Three rings of four views. */
const VIEWS = [-0.7, 0.2, 0.9].flatMap((height, ring) =>
  [0, 1, 2, 3].map((quarter) => [0.5 * ring + (Math.PI * quarter) / 2, height]),
);

async function sceneOf(glb) {
  const { scene } = await new GLTFLoader().parseAsync(glb.slice().buffer, '');
  const all = new THREE.Scene();
  const sun = new THREE.DirectionalLight(0xffffff, 2.5);
  sun.position.set(2, 3, 4);
  all.add(scene, sun, new THREE.HemisphereLight(0xffffff, 0x404050, 1.2));
  return all;
}

/** The pixels of every view, on a transparent ground. */
async function drawn(glb) {
  const canvas = document.createElement('canvas');
  const renderer = new THREE.WebGLRenderer({ canvas, alpha: true, preserveDrawingBuffer: true });
  renderer.setSize(SIDE, SIDE, false);
  const scene = await sceneOf(glb);
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 100);
  const gl = renderer.getContext();
  const pictures = VIEWS.map(([angle, height]) => {
    camera.position.set(Math.cos(angle), height, Math.sin(angle)).setLength(5.5);
    camera.lookAt(0, 0, 0);
    renderer.render(scene, camera);
    const pixels = new Uint8Array(4 * SIDE * SIDE);
    gl.readPixels(0, 0, SIDE, SIDE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  });
  renderer.dispose();
  return pictures;
}

/** Whether a pixel and those around it show the mesh. */
function isInside(pixels, x, y) {
  for (let j = y - 2; j <= y + 2; ++j)
    for (let i = x - 2; i <= x + 2; ++i) if (pixels[4 * (j * SIDE + i) + 3] !== 255) return false;
  return true;
}

function difference(before, after) {
  let [sum, count] = [0, 0];
  for (let y = 2; y < SIDE - 2; ++y)
    for (let x = 2; x < SIDE - 2; ++x) {
      if (!isInside(before, x, y) || !isInside(after, x, y)) continue;
      ++count;
      for (let c = 0; c < 3; ++c) {
        const at = 4 * (y * SIDE + x) + c;
        sum += Math.abs(before[at] - after[at]) / 255 / 3;
      }
    }
  return { mean: sum / count, share: count / SIDE ** 2 };
}

/** The mean difference of each view, how much of it is compared, and how much views differ from each other. */
export async function compared(before, after) {
  const [old, made] = [await drawn(before), await drawn(after)];
  return {
    views: old.map((picture, i) => difference(picture, made[i])),
    contrast: difference(old[0], old[6]).mean,
  };
}

export const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
