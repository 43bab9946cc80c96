import type { Abflat } from 'abflat';
import { isFbx } from '../base/mesh-files';
import type { NamedMesh } from '../files/joined-obj';
import type { DisplayMesh } from '../mesh/mesh';
import { type FileSource, type GltfFiles, isGltf } from '../model/model';
import { inOwnWorker } from '../workshop/start-worker';
import type { Workshop } from '../workshop/workshop';

/** Who reads and writes. */
export interface Joiners {
  abflat: Abflat;
  workshop: Workshop;
}

/**
 * Several meshes as one file, so that they are unwrapped into one atlas. If there is a glTF, that is
 * one GLB with all that is in such files, and the shapes of the others; otherwise each mesh becomes an
 * object of an OBJ.
 */
export async function oneFile(
  sources: FileSource[],
  joiners: Joiners,
  signal: AbortSignal,
): Promise<File> {
  const isGlb = sources.some(isGltf);
  const file = await (isGlb ? oneGlb : oneObj)(sources, joiners, signal);
  signal.throwIfAborted();
  return new File([file], nameOf(sources, isGlb ? 'glb' : 'obj'), { type: file.type });
}

/** What is compressed may be decoded forever, so it has a worker of its own. */
async function oneGlb(sources: FileSource[], joiners: Joiners, signal: AbortSignal): Promise<Blob> {
  const files: GltfFiles[] = [];
  for (const source of sources) {
    files.push(await (isGltf(source) ? filesOf : shapeOf)(source, joiners, signal));
  }
  return inOwnWorker('joiner', (tasks) => tasks.joinedGlb(files), signal);
}

async function filesOf(
  source: FileSource,
  { workshop }: Joiners,
  signal: AbortSignal,
): Promise<GltfFiles> {
  const { name, file, others } = source;
  return isFbx(name) ? (await workshop.gltf(source, signal)).files : { file, others };
}

async function shapeOf(
  source: FileSource,
  joiners: Joiners,
  signal: AbortSignal,
): Promise<GltfFiles> {
  const name = baseOf(source);
  const glb = await joiners.workshop.shapeGlb(name, await read(source, joiners, signal));
  return { file: new File([glb], `${name}.glb`), others: [] };
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
