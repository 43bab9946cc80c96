import type { Abflat, MeshInput } from 'abflat';
import { download } from '../base/download';
import { exportedFile, exportFormatOf, meshFileOf } from '../base/mesh-files';
import { type Bakeable, bakedFormats, type ImageSide } from '../model/baking';
import type { Outcome } from '../model/model';
import { writeAgain } from '../session/write-again';
import { BAKING } from '../words/baking';
import { EXPORTED, SAVED } from '../words/exported';
import type { ExportFormat } from '../words/generated-formats';
import { bakedFile } from '../workshop/baked-file';
import type { Workshop } from '../workshop/workshop';

/** What is to be written. */
export interface ExportRequest {
  outcome: Outcome;
  format: ExportFormat;
  /** The set of a glTF that gets the coordinates. */
  texcoord: number;
  /** Of the new images, if the textures of a glTF are to follow its layout. */
  imageSide: ImageSide | null;
}

/** Who writes. */
export interface Writers {
  workshop: Workshop;
  /** Works on the mesh beside runs, whose abflat it uses, until it is cancelled. */
  aside<T>(work: (abflat: Abflat, input: MeshInput, signal: AbortSignal) => Promise<T>): Promise<T>;
  say(text: string): void;
  /** The share that is done of something. */
  progress(fraction: number, what: string): void;
}

/** Whether it gets new images, which are wanted only where there can be some. */
const isBaked = ({ outcome, format, imageSide }: Omit<ExportRequest, 'texcoord'>) =>
  imageSide !== null && outcome.mode !== 'flatten' && bakedFormats(outcome).includes(format);

/** What was done, for people. */
export interface Exported {
  done: string;
  /** What to know about it that takes longer to read. */
  notes: string[];
}

/** Offers the result as NAME-uv with the ending of its format. */
export async function exportMesh(request: ExportRequest, writers: Writers): Promise<Exported> {
  const { source } = request.outcome;
  const base = source.name.replace(/\.[^.]*$/, '');
  const { file, remarks, notes = [] } = await write(request, base, writers);
  const isArchive = file instanceof Blob && file.type === 'application/zip';
  const name = `${base}-uv.${isArchive ? 'zip' : request.format}`;
  download(name, isArchive ? file.type : exportedFile(request.format).type, file);
  const size = file instanceof Blob ? file.size : file.length;
  const exported = EXPORTED.exported(name, SAVED.kilobytes(size));
  return { done: [exported + after(request), ...remarks].join('. '), notes };
}

interface Output {
  file: Uint8Array | Blob;
  /** For people. */
  remarks: string[];
  notes?: string[];
}

async function write(request: ExportRequest, name: string, writers: Writers): Promise<Output> {
  const { outcome, format, texcoord, imageSide } = request;
  if (imageSide !== null && outcome.mode !== 'flatten' && isBaked(request))
    return bake(outcome, imageSide, await objFor(request, name, writers), writers);
  const own = format === 'glb' ? undefined : outcome.result[format];
  if (own) return { file: own, remarks: [] };
  if (format === 'glb' && outcome.gltf)
    return { file: await writers.workshop.glb(outcome, texcoord, name), remarks: setOf(request) };
  return convert(request, name, writers);
}

type ForObj = Pick<Parameters<typeof bakedFile>[1], 'obj' | 'objName'>;

/** What an OBJ is to become, or what is to become one: an OBJ is written first, without its images. */
async function objFor(request: ExportRequest, name: string, writers: Writers): Promise<ForObj> {
  const isObj = request.format === 'obj';
  if (request.outcome.gltf) return { obj: null, objName: isObj ? `${name}-uv` : null };
  if (!isObj) return { obj: { name, written: null }, objName: null };
  const { file } = await write({ ...request, imageSide: null }, name, writers);
  const written = file instanceof Blob ? await file.text() : new TextDecoder().decode(file);
  return { obj: { name: `${name}-uv`, written }, objName: null };
}

async function bake(
  outcome: Bakeable,
  side: ImageSide,
  forObj: ForObj,
  writers: Writers,
): Promise<Output> {
  const onProgress = (fraction: number) => writers.progress(fraction, BAKING.baking);
  const { file, images, notes } = await writers.aside((abflat, _, signal) => {
    onProgress(0);
    return bakedFile(abflat, { outcome, side, ...forObj }, { signal, onProgress });
  });
  const isStacked = outcome.mode === 'unwrap' && Boolean(outcome.stacks?.length);
  const sentences = [BAKING.images(images), ...notes.map(BAKING.note)];
  return {
    file,
    remarks: images.length > 0 ? [BAKING.done] : [],
    notes: [...sentences, isStacked ? BAKING.stacked : ''].filter(Boolean),
  };
}

/** In a format that the mesh did not come in. */
async function convert(
  { outcome, format }: ExportRequest,
  name: string,
  writers: Writers,
): Promise<Output> {
  writers.say(EXPORTED.writing(format.toUpperCase()));
  const written = await writers.aside((abflat, input, signal) =>
    writeAgain(abflat, input, outcome, format, writers.workshop, signal),
  );
  const remarks = outcome.result.report.valid && !written.isValid ? [EXPORTED.rounded] : [];
  if (format === 'glb') return { file: await writers.workshop.glb(outcome, 0, name), remarks };
  const file = written[format];
  if (!file) throw new Error(`The result came without ${exportedFile(format).title}.`);
  return { file, remarks };
}

/** Which texcoord set has the new UVs, where a file may have several. */
function setOf({ outcome: { gltf }, texcoord }: ExportRequest): string[] {
  if (!gltf) return [];
  const { texcoordSets, paintedSets } = gltf;
  if (paintedSets.includes(texcoord)) return [EXPORTED.replacedPainted(texcoord)];
  if (texcoordSets.includes(texcoord)) return [EXPORTED.replaced(texcoord)];
  const filled = Array.from({ length: texcoord }, (_, set) => set).filter(
    (set) => !texcoordSets.includes(set),
  );
  const isOnly = texcoordSets.length === 0 && texcoord === 0;
  const isPainted = paintedSets.length > 0;
  return [
    ...(isOnly ? [] : [isPainted ? EXPORTED.addedToPainted(texcoord) : EXPORTED.added(texcoord)]),
    ...(filled.length > 0 ? [EXPORTED.filled(filled)] : []),
  ];
}

function after({ outcome, format, imageSide }: ExportRequest): string {
  const { name } = outcome.source;
  if (isBaked({ outcome, format, imageSide }) && !(outcome.gltf && format === 'glb')) return '';
  const hasMore = Boolean(meshFileOf(name)?.exported);
  if (hasMore && format !== exportFormatOf(name)) return EXPORTED.shapeOnly;
  return outcome.gltf?.compressions.length ? EXPORTED.uncompressed : '';
}
