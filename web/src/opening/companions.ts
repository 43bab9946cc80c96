// Which other files a mesh on the web consists of.

import { FETCHING } from '../words/web';
import { decoded } from './address';

/** Nobody needs more for one mesh. */
const MOST = 200;

/** Those that are in the folder of the mesh or below, each once. `names`: as the mesh has them. */
export function companionsOf(mesh: URL, names: string[]): URL[] {
  const folder = new URL('.', mesh).href;
  const found = new Map<string, URL>();
  for (const name of names) {
    const url = resolved(name, mesh);
    if (url?.href.startsWith(folder) && url.href !== mesh.href) found.set(url.href, url);
  }
  if (found.size > MOST) throw new Error(FETCHING.tooManyNamed(found.size, MOST));
  return [...found.values()];
}

function resolved(name: string, mesh: URL): URL | null {
  try {
    return new URL(name, mesh);
  } catch {
    return null;
  }
}

/** Buffers and images of a glTF; none if it is no JSON, which reading it explains. */
export function namedByGltf(text: string): string[] {
  try {
    const { buffers = [], images = [] } = JSON.parse(text);
    return [...buffers, ...images]
      .map(({ uri }: { uri?: unknown }) => uri)
      .filter((uri): uri is string => typeof uri === 'string' && !uri.startsWith('data:'));
  } catch {
    return [];
  }
}

/** Names in an OBJ or MTL may hold spaces, and are not encoded as those in addresses are. */
const asAddress = (name: string) =>
  encodeURI(decoded(name.trim().replaceAll('\\', '/'))).replace(/[#?]/g, encodeURIComponent);

/** Material libraries of an OBJ; a line may name several. */
export function namedByObj(text: string): string[] {
  const lines = [...text.matchAll(/^[ \t]*mtllib[ \t]+(.+)$/gm)];
  return lines.flatMap(([, names]) => names.split(/(?<=\.mtl)[ \t]+/i).map(asAddress));
}

/** Textures of an MTL: what follows the options, which are numbers and words. */
export function namedByMtl(text: string): string[] {
  const maps = text.matchAll(/^[ \t]*(?:map_\w+|bump|norm|disp|decal|refl)[ \t]+(.+)$/gim);
  return [...maps].map(([, rest]) =>
    asAddress(rest.replace(/^(?:-\w+[ \t]+(?:(?:on|off|[-+.\d]+)[ \t]+)*)+/i, '')),
  );
}
