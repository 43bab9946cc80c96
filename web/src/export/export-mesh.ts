import { download } from '../base/download';
import { exportedFile, exportFormatOf, meshFileOf } from '../base/mesh-files';
import type { Outcome } from '../model/model';
import type { Written } from '../session/write-again';
import { EXPORT, SAVED } from '../words/export';
import type { ExportFormat } from '../words/generated-formats';
import type { Workshop } from '../workshop/workshop';

/** What is to be written. */
export interface ExportRequest {
  outcome: Outcome;
  format: ExportFormat;
  /** The set of a glTF that gets the coordinates. */
  texcoord: number;
}

/** Who writes. */
export interface Writers {
  workshop: Workshop;
  /** Asks abflat for a file that the result came without. */
  again(outcome: Outcome, format: ExportFormat): Promise<Written>;
}

/** Offers the result as NAME-uv with the ending of its format. Returns what was done, for people. */
export async function exportMesh(request: ExportRequest, writers: Writers): Promise<string> {
  const { source } = request.outcome;
  const base = source.name.replace(/\.[^.]*$/, '');
  const { file, remarks } = await write(request, base, writers);
  const name = `${base}-uv.${request.format}`;
  download(name, exportedFile(request.format).type, file);
  const size = file instanceof Blob ? file.size : file.length;
  const exported = EXPORT.exported(name, SAVED.kilobytes(size));
  return [exported + after(request), ...setOf(request), ...remarks].join('. ');
}

interface Output {
  file: Uint8Array | Blob;
  /** For people. */
  remarks: string[];
}

async function write(request: ExportRequest, name: string, writers: Writers): Promise<Output> {
  const { outcome, format, texcoord } = request;
  const own = format === 'glb' ? undefined : outcome.result[format];
  if (own) return { file: own, remarks: [] };
  if (format === 'glb' && outcome.gltf)
    return { file: await writers.workshop.glb(outcome, texcoord, name), remarks: [] };
  return convert(request, name, writers);
}

/** In a format that the mesh did not come in. */
async function convert(
  { outcome, format }: ExportRequest,
  name: string,
  writers: Writers,
): Promise<Output> {
  const written = await writers.again(outcome, format);
  const remarks = outcome.result.report.valid && !written.isValid ? [EXPORT.rounded] : [];
  if (format === 'glb') return { file: await writers.workshop.glb(outcome, 0, name), remarks };
  const file = written[format];
  if (!file) throw new Error(`The result came without ${exportedFile(format).title}.`);
  return { file, remarks };
}

/** Which texcoord set has the new UVs, where a file may have several. */
function setOf({ outcome, format, texcoord }: ExportRequest): string[] {
  const { gltf } = outcome;
  if (format !== 'glb' || !gltf || (gltf.freeTexcoord === 0 && gltf.texcoordSets === 0)) return [];
  if (gltf.paintedSets.includes(texcoord)) return [EXPORT.replacedPainted(texcoord)];
  if (texcoord < gltf.texcoordSets) return [EXPORT.replaced(texcoord)];
  const isPainted = gltf.paintedSets.length > 0;
  return [isPainted ? EXPORT.addedToPainted(texcoord) : EXPORT.added(texcoord)];
}

function after({ outcome, format }: ExportRequest): string {
  const { name } = outcome.source;
  const hasMore = Boolean(meshFileOf(name)?.exported);
  if (hasMore && format !== exportFormatOf(name)) return EXPORT.shapeOnly;
  return outcome.gltf?.compressions.length ? EXPORT.uncompressed : '';
}
