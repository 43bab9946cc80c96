import type { Abflat } from 'abflat';
import { copied } from '../base/buffers';
import {
  type AnyProgress,
  exportFormat,
  type Opened,
  type Outcome,
  type Source,
} from '../model/model';
import type { Kept, Settings } from '../model/settings';

interface Watch {
  signal: AbortSignal;
  onProgress: (progress: AnyProgress) => void;
}

/**
 * Charts that an edit leaves unchanged are not flattened again; locked ones stay where they are.
 */
function fromEarlier(source: Source, kept: Kept | undefined, earlier: Outcome | null) {
  if (kept && kept.charts.length > 0) return { known: kept.layout, fixedCharts: kept.charts };
  const isKnown = earlier?.mode === 'unwrap' && earlier.source === source;
  return { known: isKnown ? earlier.result : undefined };
}

/** One run of abflat with these settings. `earlier`: the last outcome, of any mesh. */
export async function layOut(
  abflat: Abflat,
  { source, input, mesh, gltf }: Opened,
  settings: Settings,
  earlier: Outcome | null,
  watch: Watch,
): Promise<Outcome> {
  const format = exportFormat(source);
  const file = format === 'glb' ? {} : { [format]: true };
  if (settings.mode === 'flatten') {
    const { mode, ...options } = settings;
    const result = await abflat.flatten(await copied(input), {
      ...options,
      ...file,
      // In the unit of the mesh, a texture would repeat as often as the mesh is large.
      normalize: true,
      transfer: true,
      roundsForGltf: format === 'glb',
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
    roundsForGltf: format === 'glb',
    ...watch,
  });
  return { mode, source, mesh, gltf, settings, result };
}
