import type { Abflat } from 'abflat';
import { copied } from '../base/buffers';
import {
  type AnyProgress,
  type ExportFormat,
  exportFormat,
  type Opened,
  type Outcome,
  type Source,
} from '../model/model';
import type { Kept, Settings } from '../model/settings';

interface Watch {
  signal: AbortSignal;
  onProgress?: (progress: AnyProgress) => void;
}

type Input = Pick<Opened, 'source' | 'input' | 'mesh' | 'gltf'>;

/**
 * Charts that an edit leaves unchanged are not flattened again; locked ones stay where they are.
 */
function fromEarlier(source: Source, kept: Kept | undefined, earlier: Outcome | null) {
  if (kept && kept.charts.length > 0) return { known: kept.layout, fixedCharts: kept.charts };
  const isKnown = earlier?.mode === 'unwrap' && earlier.source === source;
  return { known: isKnown ? earlier.result : undefined };
}

/**
 * One run of abflat with these settings. `earlier`: the last outcome, of any mesh; `format`: that of
 * the file to write.
 */
export async function layOut(
  abflat: Abflat,
  { source, input, mesh, gltf }: Input,
  settings: Settings,
  earlier: Outcome | null,
  watch: Watch,
  format: ExportFormat = exportFormat(source),
): Promise<Outcome> {
  const roundsForGltf = exportFormat(source) === 'glb';
  const file = format === 'glb' ? {} : { [format]: true };
  if (settings.mode === 'flatten') {
    const { mode, ...options } = settings;
    const result = await abflat.flatten(await copied(input), {
      ...options,
      ...file,
      // In the unit of the mesh, a texture would repeat as often as the mesh is large.
      normalize: true,
      transfer: true,
      roundsForGltf,
      ...watch,
    });
    return { mode, source, mesh, gltf, settings, result };
  }
  const { mode, kept, ...options } = settings;
  const result = await abflat.unwrap(await copied(input), {
    ...options,
    ...fromEarlier(source, kept, earlier),
    ...file,
    transfer: true,
    roundsForGltf,
    ...watch,
  });
  return { mode, source, mesh, gltf, settings, result };
}
