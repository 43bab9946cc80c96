// The version: its owner is the header, and other files repeat it.

/** Each file that names the version, and where it does. */
export const PLACES = {
  'core/include/abflat/version.h': /(?<=ABFLAT_VERSION ")[^"]+/g,
  'wasm/package.json': /(?<=^ {2}"version": ")[^"]+/gm,
  'package-lock.json': /(?<="name": "abflat",\s+"version": ")[^"]+/g,
  'packaging/vcpkg/vcpkg.json': /(?<="version-semver": ")[^"]+/g,
  'wasm/README.md': /(?<=abflat@)[\d.]+/g,
};

export const isVersion = (text) => /^\d+\.\d+\.\d+$/.test(text);

const UNRELEASED = '(unreleased)';
const HEADING = /^## (\S+) (?:- )?(\S+)$/gm;

/** The versions of the changelog, newest first: `{ version, released }`, the latter a date or undefined. */
export const versionsIn = (changes) =>
  [...changes.matchAll(HEADING)].map(([, version, when]) => ({
    version,
    released: when === UNRELEASED ? undefined : when,
  }));

/** Opens a version in the changelog, or renames the one that is open. */
export function openVersion(changes, version) {
  const heading = `## ${version} ${UNRELEASED}`;
  const [{ released }] = versionsIn(changes);
  return changes.replace(/^## .*$/m, (newest) => (released ? `${heading}\n\n${newest}` : heading));
}
