import type { Abflat, FlattenResult, Progress, UnwrapProgress, UnwrapResult } from 'abflat';
import type { Kept } from './charts/locks';
import { exportFormat } from './export-mesh';
import type { DisplayMesh } from './mesh';
import type { Opened, Source } from './session';
import type { FlattenSettings, Settings, UnwrapSettings } from './settings';
import { copied } from './workshop/buffers';
import type { GltfFile } from './workshop/gltf-file';

export type AnyProgress = Progress | UnwrapProgress;

interface Made {
  source: Source;
  /** What went in. */
  mesh: DisplayMesh;
  /** Where it came from one. */
  gltf?: GltfFile;
}

export interface Flattened extends Made {
  mode: 'flatten';
  settings: FlattenSettings;
  result: FlattenResult;
}

export interface Unwrapped extends Made {
  mode: 'unwrap';
  settings: UnwrapSettings;
  result: UnwrapResult;
}

export type Outcome = Flattened | Unwrapped;

interface Watch {
  signal: AbortSignal;
  onProgress: (progress: AnyProgress) => void;
}

/** Charts that an edit leaves as they were are not flattened again, locked ones stay where they are. */
function fromEarlier(source: Source, kept: Kept | undefined, earlier: Outcome | null) {
  if (kept && kept.charts.length > 0) return { known: kept.layout, fixedCharts: kept.charts };
  const isKnown = earlier?.mode === 'unwrap' && earlier.source === source;
  return { known: isKnown ? earlier.result : undefined };
}

/** One run of abflat, in the way the settings ask for; `earlier`: the last outcome, of whatever mesh. */
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
      // In the unit of the mesh it would repeat a texture as often as the mesh is large.
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
