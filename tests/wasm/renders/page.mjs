// Runs in the page: bakes a GLB into a new layout and draws it before and after.

import { WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { createAbflat } from 'abflat';
import { pack, unwrap } from 'abflat/gltf';
import { bytesOf, compared } from '../../support/glb-renders.mjs';

async function bakedWith(name, bytes, options) {
  const abflat = await createAbflat();
  const io = new WebIO().registerExtensions(ALL_EXTENSIONS);
  const document = await io.readBinary(bytes);
  let baked;
  const onAtlas = (atlas) => {
    baked = atlas.baked;
  };
  const transform = { pack, unwrap }[name];
  await document.transform(transform(abflat, { ...options, bake: true, onAtlas }));
  abflat.terminate();
  return {
    glb: await io.writeBinary(document),
    images: baked.map(({ maps, side }) => [maps.join(), side]),
  };
}

/** What is new in its images, and how views of it differ. */
window.compare = async (name, glb, options) => {
  const bytes = bytesOf(glb);
  const baked = await bakedWith(name, bytes, options);
  return { images: baked.images, ...(await compared(bytes, baked.glb)) };
};
