import type { Abflat, FlattenResult, Progress, UnwrapProgress, UnwrapResult } from 'abflat';
import { exportFormat } from './export-mesh';
import type { GltfFile } from './gltf-file';
import type { DisplayMesh } from './mesh';
import type { Opened, Source } from './session';
import type { FlattenSettings, Settings, UnwrapSettings } from './settings';

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
    const result = await abflat.flatten(input, { ...options, ...file, ...watch });
    return { mode, source, mesh, gltf, settings, result };
  }
  const { mode, ...options } = settings;
  // Charts that an edit leaves as they were are not flattened again.
  const known = earlier?.mode === mode && earlier.source === source ? earlier.result : undefined;
  const result = await abflat.unwrap(input, {
    ...options,
    known,
    ...file,
    roundsForGltf: format === 'glb',
    ...watch,
  });
  return { mode, source, mesh, gltf, settings, result };
}
