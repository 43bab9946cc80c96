import type { Abflat, PackResult } from 'abflat';
import { copied } from '../base/buffers';
import { exportFormatOf } from '../base/mesh-files';
import type { AnyProgress, Helpers, Opened, Packed } from '../model/model';
import type { PackSettings } from '../model/settings';
import type { ExportFormat } from '../words/generated-formats';
import { ownTiles } from './own-tiles';

/** Layouts of UDIM tiles have some, not one far away. */
const MOST_TILES = 200;

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
  helpers: Pick<Helpers, 'namedParts'>,
  format: ExportFormat = exportFormatOf(source.name),
): Promise<Packed> {
  const { mode, tiles = 'one', ...options } = settings;
  const opened = { source, input, mesh, gltf };
  const own =
    tiles !== 'one' && (await ownTiles(abflat, opened, settings, tiles, watch.signal, helpers));
  const pack = async (udim: boolean) =>
    abflat.pack(await copied(gltf?.mesh ?? input), {
      ...options,
      ...own,
      udim,
      ...(format === 'glb' ? {} : { [format]: true }),
      transfer: true,
      roundsForGltf: format === 'glb' || exportFormatOf(source.name) === 'glb',
      ...watch,
    });
  const inSquare = await pack(false);
  const inTiles = settings.keepPlaces && inSquare.report.faces.outside > 0 && (await pack(true));
  const result = inTiles && isInTiles(inTiles) ? inTiles : inSquare;
  // Vertices that were joined for unwrapping are not joined here.
  return { mode, source, mesh: gltf?.mesh ?? mesh, ...(gltf && { gltf }), settings, result };
}

/** Whether the layout is one of UDIM tiles: each island lies in one. */
const isInTiles = ({ report }: PackResult) =>
  report.faces.outside === 0 && report.tiles <= MOST_TILES;

/** Tells islands that are stacked on purpose from those that overlap. */
export async function tellStacks(
  packed: Packed,
  helpers: Pick<Helpers, 'fileStacks'>,
): Promise<Packed> {
  const { settings, result } = packed;
  if (!settings.keepPlaces || result.report.faces.overlapping === 0) return packed;
  return { ...packed, fileStacks: await helpers.fileStacks(packed) };
}
