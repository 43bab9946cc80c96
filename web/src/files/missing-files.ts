import { LOOK_FILES } from '../words/looks';

/** Sentences about the files that `mesh` names: those that are not there, and images that cannot be decoded. */
export function remarksOn(mesh: string, missing: string[], undecoded: string[]): string[] {
  const [absent, broken] = [missing, undecoded].map((names) => [...new Set(names)]);
  const remarks: string[] = [];
  if (absent.length > 0) remarks.push(LOOK_FILES.missing(mesh, absent));
  if (broken.length > 0) remarks.push(LOOK_FILES.undecoded(broken));
  return remarks;
}

/**
 * The file of that name which has the most folders in common with the path, where they are known: a
 * browser does not tell where files are, but an archive does. Capitals make no difference.
 */
export function fileNamed(path: string, files: File[]): File | undefined {
  const wanted = partsOf(path);
  let best: File | undefined;
  let most = 0;
  for (const file of files) {
    const parts = partsOf(file.name);
    const apart = wanted.findIndex((part, i) => part !== parts[i]);
    const common = apart < 0 ? wanted.length : apart;
    if (common > most) [best, most] = [file, common];
  }
  return best;
}

/** The name, then its folders from the innermost one. */
const partsOf = (path: string) => path.toLowerCase().split(/[\\/]/).reverse();

/** Without its folders. */
export const nameOf = (path: string): string => path.split(/[\\/]/).at(-1) ?? path;
