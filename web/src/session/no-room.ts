// Why an atlas has too little room, in the words of the page.

import { RESOLUTIONS } from '../model/settings';
import { NO_ROOM } from '../words/run';

/** How abflat says which texel density and which resolution would do. */
const TOO_DENSE =
  /^at (\S+) texels per unit (?:(chart \d+)|the charts) .* tile of (\d+) texels\. Lower the density to ([^,\s]+)(?:,? (?:or )?raise the resolution to (\d+))?/;

/** A text of abflat as it is, or what to do on the page where it is about room. */
export function inRoomWords(text: string): string {
  const found = TOO_DENSE.exec(text);
  if (!found) return text;
  const [, density, one, resolution, most, least] = found;
  const enough = RESOLUTIONS.find((texels) => texels >= Number(least ?? Infinity));
  return NO_ROOM.tooDense(Number(density), Number(resolution), Boolean(one), Number(most), enough);
}
