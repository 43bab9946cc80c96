import type { Abflat } from 'abflat';
import { copied } from '../base/buffers';
import { exportFormatOf } from '../base/mesh-files';
import type { AnyProgress, Opened, Packed } from '../model/model';
import type { PackSettings } from '../model/settings';
import type { ExportFormat } from '../words/generated-formats';

interface Watch {
  signal: AbortSignal;
  onProgress?: (progress: AnyProgress) => void;
}

/** The UVs of the file, as they are or packed. `format`: that of the file to write. */
export async function packUvs(
  abflat: Abflat,
  { source, input, mesh, gltf }: Pick<Opened, 'source' | 'input' | 'mesh' | 'gltf'>,
  settings: PackSettings,
  watch: Watch,
  format: ExportFormat = exportFormatOf(source.name),
): Promise<Packed> {
  const { mode, ...options } = settings;
  const result = await abflat.pack(await copied(gltf?.mesh ?? input), {
    ...options,
    ...(format === 'glb' ? {} : { [format]: true }),
    transfer: true,
    roundsForGltf: format === 'glb' || exportFormatOf(source.name) === 'glb',
    ...watch,
  });
  // Vertices that were joined for unwrapping are not joined here.
  return { mode, source, mesh: gltf?.mesh ?? mesh, ...(gltf && { gltf }), settings, result };
}
