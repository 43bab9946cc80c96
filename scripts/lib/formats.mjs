// The formats of mesh files: what core/schema/formats.json may contain, and lists made of it.

import { checkUnique } from './schema.mjs';

/** How exactly a written file holds texcoords, in words. */
export const PRECISIONS = {
  double: 'texcoords in double precision',
  single: 'texcoords in single precision, double if needed',
  gltf: 'texcoords in single precision, v from the top',
};

/** Returns the schema, or throws one sentence that names the format at fault. */
export function checkFormats(schema) {
  const { formats } = schema;
  checkUnique(formats, 'formats');
  formats.forEach(checkFormat);
  const endings = filesOf(formats).map(({ ending }) => ending);
  const twice = endings.find((ending, i) => endings.indexOf(ending) < i);
  if (twice) throw new Error(`formats: ${twice} is listed twice`);
  // Their places are their numbers, in the core and in the package.
  const ranks = formats.map(({ library, precision }) => (library ? 2 : precision ? 0 : 1));
  const late = ranks.findIndex((rank, i) => i > 0 && rank < ranks[i - 1]);
  if (late > 0)
    throw new Error(
      `formats: ${formats[late].name} is too late. First come those that the core writes, then those that it only reads`,
    );
  return schema;
}

function checkFormat({ name, title, precision, encoding, library, files }) {
  const fault = (what) => new Error(`format ${name}: ${what}`);
  if (!title) throw fault('it has no title');
  if (precision !== undefined && !Object.hasOwn(PRECISIONS, precision))
    throw fault(`unknown precision "${precision}"`);
  if (precision && !library && !encoding) throw fault('it has no encoding');
  if (!files?.length) throw fault('it has no files');
  for (const { ending, type } of files) {
    if (!/^\.[a-z0-9]+$/.test(ending)) throw fault(`bad ending "${ending}"`);
    if (!/^[a-z]+\/[a-z0-9+.-]+$/.test(type)) throw fault(`bad type "${type}" of ${ending}`);
  }
}

/** Those that the core reads. */
export const coreFormats = (formats) => formats.filter(({ library }) => !library);

export const writtenFormats = (formats) => formats.filter(({ precision }) => precision);

/** Every kind of file with the format that it is of. */
export const filesOf = (formats) =>
  formats.flatMap((format) => format.files.map((file) => ({ ...file, format })));

/** What a kind of file is called: "GLB". */
export const titleOf = ({ title, format }) => title ?? format.title;

/** All that formats and their files are called. */
export const namesOf = (formats) =>
  formats.flatMap(({ title, files }) => [
    ...new Set([title, ...files.map((file) => file.title ?? title)]),
  ]);

/** "a, b or c" */
export function listed(words, conjunction = 'or') {
  const last = words.at(-1);
  return words.length < 2 ? last : `${words.slice(0, -1).join(', ')} ${conjunction} ${last}`;
}
