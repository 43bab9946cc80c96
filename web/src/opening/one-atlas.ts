import type { Abflat } from 'abflat';
import type { NamedMesh } from '../files/joined-obj';
import type { DisplayMesh } from '../mesh/mesh';
import { type FileSource, isGltf } from '../model/model';
import { inOwnWorker } from '../workshop/start-worker';
import type { Workshop } from '../workshop/workshop';

/** Who reads and writes. */
export interface Joiners {
  abflat: Abflat;
  workshop: Workshop;
}

/**
 * Several meshes as one file, so that they are unwrapped into one atlas. glTF files become one GLB
 * with all that is in them; with others among them, each becomes an object of an OBJ.
 */
export async function oneFile(
  sources: FileSource[],
  joiners: Joiners,
  signal: AbortSignal,
): Promise<File> {
  const isWhole = sources.every(isGltf);
  const file = isWhole ? await oneGlb(sources, signal) : await oneObj(sources, joiners, signal);
  signal.throwIfAborted();
  return new File([file], nameOf(sources, isWhole ? 'glb' : 'obj'), { type: file.type });
}

/** What is compressed may be decoded forever, so it has a worker of its own. */
function oneGlb(sources: FileSource[], signal: AbortSignal): Promise<Blob> {
  const files = sources.map(({ file, others }) => ({ file, others }));
  return inOwnWorker('joiner', (tasks) => tasks.joinedGlb(files), signal);
}

async function oneObj(sources: FileSource[], joiners: Joiners, signal: AbortSignal): Promise<Blob> {
  const meshes: NamedMesh[] = [];
  for (const source of sources) {
    const { positions, indices, faces } = await read(source, joiners, signal);
    meshes.push({ name: baseOf(source), positions, indices, faces });
  }
  return joiners.workshop.joinedObj(meshes);
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

const nameOf = (sources: FileSource[], ending: string) =>
  `${baseOf(sources[0])}-and-${sources.length - 1}-more.${ending}`;
