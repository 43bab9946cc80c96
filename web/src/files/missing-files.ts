import { LOOK_FILES } from '../words/looks';

/** Sentences about the files that `mesh` names: those that are not there, and images that cannot be decoded. */
export function remarksOn(mesh: string, missing: string[], undecoded: string[]): string[] {
  const [absent, broken] = [missing, undecoded].map((names) => [...new Set(names)]);
  const remarks: string[] = [];
  if (absent.length > 0) remarks.push(LOOK_FILES.missing(mesh, absent));
  if (broken.length > 0) remarks.push(LOOK_FILES.undecoded(broken));
  return remarks;
}

/** By name only, as a browser does not tell where files are; capitals make no difference. */
export function fileNamed(path: string, files: File[]): File | undefined {
  const wanted = nameOf(path).toLowerCase();
  return files.find(({ name }) => name.toLowerCase() === wanted);
}

/** Without its folders. */
export const nameOf = (path: string): string => path.split(/[\\/]/).at(-1) ?? path;
