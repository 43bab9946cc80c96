import type { Abflat } from 'abflat';
import type { NamedMesh } from '../files/joined-obj';
import type { DisplayMesh } from '../mesh/mesh';
import { type FileSource, isGltf } from '../model/model';
import type { Workshop } from '../workshop/workshop';

/** Who reads and writes. */
export interface Joiners {
  abflat: Abflat;
  workshop: Workshop;
}

/** Several meshes as one file in which each is an object, so that they are unwrapped into one atlas. */
export async function oneFile(
  sources: FileSource[],
  joiners: Joiners,
  signal: AbortSignal,
): Promise<File> {
  const meshes: NamedMesh[] = [];
  for (const source of sources) {
    const { positions, indices, faces } = await read(source, joiners, signal);
    meshes.push({ name: baseOf(source), positions, indices, faces });
  }
  const text = await joiners.workshop.joinedObj(meshes);
  signal.throwIfAborted();
  return new File([text], nameOf(sources), { type: text.type });
}

async function read(
  source: FileSource,
  { abflat, workshop }: Joiners,
  signal: AbortSignal,
): Promise<DisplayMesh> {
  if (isGltf(source)) return (await workshop.gltf(source, signal)).mesh;
  const bytes = new Uint8Array(await source.file.arrayBuffer());
  return abflat.load({ bytes, name: source.name }, { signal, transfer: true });
}

const baseOf = ({ name }: FileSource) => name.replace(/\.[^.]*$/, '');

const nameOf = (sources: FileSource[]) =>
  `${baseOf(sources[0])}-and-${sources.length - 1}-more.obj`;
