// What there is to say of the UVs of a file, as they are or packed.

import type { PackReport } from 'abflat';
import { FAULTS } from '../colors/fault-colors';
import { faultyFaces } from '../model/faulty-faces';
import type { Packed } from '../model/model';
import { ended, sentence } from '../words/format';
import { BADGES, ISLANDS, UV_FAULTS } from '../words/result';
import type { Verdict } from './remedy';

/** "12 faces overlap, 3 faces flipped"; '' if no face has a fault. */
function faultsText(packed: Packed): string {
  const faces = faultyFaces(packed);
  return FAULTS.filter((fault) => faces[fault] > 0)
    .map((fault) => UV_FAULTS[fault](faces[fault]))
    .join(', ');
}

export function ofIslands(packed: Packed): Verdict {
  return packed.settings.keepPlaces ? ofFile(packed) : ofPacked(packed.result.report);
}

/** What lies on each other, or is mirrored, may do so on purpose. */
function ofFile(packed: Packed): Verdict {
  const { report } = packed.result;
  const reason = faultsText(packed);
  if (!reason) return { badge: BADGES.valid, reason: ISLANDS.noFaults, remedy: null };
  if (report.valid) return { badge: BADGES.asInFile, reason, remedy: null };
  return { badge: BADGES.notValid, reason, remedy: 'islands' };
}

function ofPacked({ valid, notes, stacked, mirrored }: PackReport): Verdict {
  if (!valid) return { badge: BADGES.notValid, reason: sentence(notes.at(-1) ?? ''), remedy: null };
  const reason = ISLANDS.packed(stacked.islands, mirrored);
  return { badge: BADGES.valid, reason, remedy: null };
}

export const islandsSummary = ({ islands, stacked, mirrored, separated }: PackReport): string =>
  ended(ISLANDS.summary(islands, stacked.islands, mirrored, separated));

/** One sentence each. */
export function islandNotes({ settings, result: { report }, gltf }: Packed): string[] {
  const { unmapped, notes } = report;
  const unseen = settings.keepPlaces && unmapped > 0 ? [ISLANDS.unmapped(unmapped)] : [];
  return [...(gltf?.notes ?? []), ...unseen, ...notes].map((note) => ended(sentence(note)));
}
