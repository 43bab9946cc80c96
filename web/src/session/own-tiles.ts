import type { Abflat, PackOptions } from 'abflat';
import { copied } from '../base/buffers';
import { movedApart, tilesOfFile, tilesOfParts } from '../mesh/own-tiles';
import { cornerUv } from '../model/arrangeable';
import type { Helpers, Opened } from '../model/model';
import type { PackSettings, Tiles } from '../model/settings';

type Asked = Pick<PackOptions, 'uv' | 'tileOfIsland'>;

/**
 * What to ask of packing so that islands go to tiles: those that they are in, or one for each object
 * or material. Objects are moved apart before, as what lies on each other would stay together.
 */
export async function ownTiles(
  abflat: Abflat,
  opened: Pick<Opened, 'source' | 'input' | 'mesh' | 'gltf'>,
  { resolution, uv: given }: PackSettings,
  tiles: Exclude<Tiles, 'one'>,
  signal: AbortSignal,
  helpers: Pick<Helpers, 'namedParts'>,
): Promise<Asked> {
  const { uv, indices, islandOfTriangle, report } = await abflat.pack(
    await copied(opened.gltf?.mesh ?? opened.input),
    { keepPlaces: true, resolution, uv: given, transfer: true, signal },
  );
  const corners = cornerUv({ uv, indices });
  if (tiles === 'file')
    return { uv: given, tileOfIsland: tilesOfFile(corners, islandOfTriangle, report.islands) };
  const { objects, materials } = await helpers.namedParts(opened);
  const parts = tiles === 'object' ? objects : materials;
  const tileOfIsland = tilesOfParts(parts, islandOfTriangle, report.islands);
  return { uv: movedApart(corners, islandOfTriangle, tileOfIsland), tileOfIsland };
}
