// Gives a scene a light map: node light-map.mjs FOLDER [SIDE [RAYS]]
// Writes FOLDER/light-map.png, and FOLDER/scene.glb, which is lit by it.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createAbflat } from 'abflat';
import { unwrapScene } from 'abflat/three';
import { glbOf } from './glb.mjs';
import { lightOn } from './light.mjs';
import { pngOf } from './png.mjs';
import { courtyard } from './scene.mjs';

const [folder = 'light-map', side = 256, rays = 64] = process.argv.slice(2);

const abflat = await createAbflat();
const scene = courtyard();
const { result, meshes } = await unwrapScene(abflat, scene, {
  preset: 'lightmap', // texels of its own for each mesh, in uv1
  resolution: Number(side),
  weights: ({ name }) => (name.startsWith('wall') ? 0.5 : 1), // seen from afar
});
abflat.terminate();

const { padding, resolution, texelDensity } = result.report.atlas;
const png = pngOf(lightOn(meshes, { side: resolution, rays: Number(rays), spread: padding }));
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, 'light-map.png'), png);
writeFileSync(join(folder, 'scene.glb'), await glbOf(meshes, png));
console.log(`${meshes.length} meshes, ${texelDensity.toFixed(1)} texels per unit`);
