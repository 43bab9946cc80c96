import { download } from '../base/download';
import { count } from '../base/format';
import { exportFormat, type Outcome } from '../model/model';
import type { Workshop } from '../workshop/workshop';

/**
 * Offers the result as NAME-uv with the extension of its format; in a glTF the coordinates become
 * TEXCOORD_`texcoord`. Returns a description of what was done, for display.
 */
export async function exportMesh(
  outcome: Outcome,
  texcoord: number,
  workshop: Workshop,
): Promise<string> {
  const { source } = outcome;
  const format = exportFormat(source);
  const file = format === 'glb' ? await workshop.glb(outcome, texcoord) : outcome.result[format];
  if (!file) throw new Error(`The result came without ${format.toUpperCase()}.`);
  const name = `${source.name.replace(/\.[^.]*$/, '')}-uv.${format}`;
  download(name, TYPES[format], file);
  const size = file instanceof Blob ? file.size : file.length;
  const uncompressed = outcome.gltf?.compressions.length ? ', uncompressed' : '';
  const exported = `Exported ${name}, ${count(Math.ceil(size / 1024))}\u202fKB${uncompressed}`;
  return outcome.gltf?.freeTexcoord ? `${setText(texcoord)} ${exported}` : exported;
}

function setText(texcoord: number): string {
  return texcoord === 0
    ? 'New UVs replaced TEXCOORD_0: textures painted for the old ones no longer fit.'
    : `New UVs are in TEXCOORD_${texcoord}; textures keep theirs.`;
}

const TYPES = { obj: 'model/obj', ply: 'model/ply', glb: 'model/gltf-binary' };
