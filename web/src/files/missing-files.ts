/** The most names in a sentence. */
const NAMED = 3;

/** "a", "a and b", "a, b and c", "a, b, c and 4 more". */
export function listed(names: string[]): string {
  const shown = names.length > NAMED + 1 ? names.slice(0, NAMED) : names;
  const rest = names.length - shown.length;
  const all = rest > 0 ? [...shown, `${rest} more`] : shown;
  return all.length < 2 ? all.join('') : `${all.slice(0, -1).join(', ')} and ${all.at(-1)}`;
}

/** Sentences about the files that `mesh` names: those that are not there, and images that cannot be decoded. */
export function remarksOn(mesh: string, missing: string[], undecoded: string[]): string[] {
  const [absent, broken] = [missing, undecoded].map((names) => [...new Set(names)]);
  const remarks: string[] = [];
  if (absent.length > 0) {
    const [is, them] = absent.length > 1 ? ['are', 'them'] : ['is', 'it'];
    remarks.push(
      `${mesh} names ${listed(absent)}, which ${is} missing: drop ${them} together with the mesh.`,
    );
  }
  if (broken.length > 0)
    remarks.push(
      `This browser cannot decode ${listed(broken)}: save ${broken.length > 1 ? 'them' : 'it'} as PNG or JPEG.`,
    );
  return remarks;
}

/** By name only, as a browser does not tell where files are; capitals make no difference. */
export function fileNamed(path: string, files: File[]): File | undefined {
  const wanted = nameOf(path).toLowerCase();
  return files.find(({ name }) => name.toLowerCase() === wanted);
}

/** Without its folders. */
export const nameOf = (path: string): string => path.split(/[\\/]/).at(-1) ?? path;
