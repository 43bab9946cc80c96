// The formats of mesh files for the core, the program and the page.

import { coreFormats, filesOf, listed, namesOf, titleOf, writtenFormats } from './formats.mjs';
import { enumClass, HEADER, literal, switchFunction } from './generate-cpp.mjs';
import { TS_HEADER, literal as tsLiteral, union } from './generate-ts.mjs';
import { pascalCase } from './schema.mjs';

const titles = (formats) => formats.map(({ title }) => title);

const textConstant = (name, text) => `constexpr const char* ${name} = ${literal(text)};`;

const enumOf = (name, text, formats) =>
  enumClass(
    name,
    text,
    formats.map((format, i) => [pascalCase(format.name), i, format.text]),
  );

/** A table of endings; `struct` is a row of it. */
function endingTable(struct, constant, type, formats) {
  const rows = filesOf(formats).map(
    ({ ending, format }) => `    {${literal(ending)}, ${type}::${pascalCase(format.name)}},`,
  );
  return [
    `/// How names of files end, in lower case.\nstruct ${struct} {\n  const char* ending;\n  ${type} format;\n};\n`,
    `constexpr ${struct} ${constant}[] = {\n${rows.join('\n')}\n};\n`,
  ];
}

const precisionFunction = (type, formats) =>
  switchFunction(
    `constexpr Precision precisionOf(${type} code)`,
    type,
    formats.map(({ name, precision = 'none' }) => [
      pascalCase(name),
      `Precision::${pascalCase(precision)}`,
    ]),
    'Precision::None',
  );

/** Of the core. */
export function renderMeshFormat({ formats }) {
  const ours = coreFormats(formats);
  const parts = [
    HEADER,
    'namespace abflat {\n',
    enumOf(
      'MeshFormat',
      'The formats that readMesh reads; those that writeMesh writes come first.',
      ours,
    ),
    `constexpr int kMeshFormatCount = ${ours.length};`,
    `constexpr int kWrittenFormatCount = ${writtenFormats(ours).length};\n`,
    '/// For messages.',
    `#define ABFLAT_MESH_FORMATS ${literal(listed(titles(ours)))}\n`,
    ...endingTable('MeshEnding', 'kMeshEndings', 'MeshFormat', ours),
    '/// How exactly a written file holds texcoords.',
    'enum class Precision {\n  None,    ///< it is not written\n  Double,\n  Single,\n  Gltf     ///< single, with v from the top\n};\n',
    precisionFunction('MeshFormat', ours),
    '}  // namespace abflat',
  ];
  return `${parts.join('\n')}\n`;
}

/** Of the program, which knows all formats. */
export function renderFileFormat({ formats }) {
  const ours = coreFormats(formats);
  const endings = (some) => filesOf(some).map(({ ending }) => ending);
  const parts = [
    HEADER,
    '#include "abflat/generated/mesh_format.h"\n',
    'namespace abflat::cli {\n',
    enumOf('FileFormat', 'All formats; those of the core come first, with its numbers.', formats),
    '/// "OBJ"',
    switchFunction(
      'inline const char* titleOf(FileFormat code)',
      'FileFormat',
      formats.map(({ name, title }) => [pascalCase(name), literal(title)]),
      literal(''),
    ),
    `/// What is written where no name tells.\nconstexpr FileFormat kUnnamedFormat = FileFormat::${pascalCase(formats[0].name)};\n`,
    ...endingTable('FileEnding', 'kFileEndings', 'FileFormat', formats),
    precisionFunction('FileFormat', formats),
    '// For messages and the help.',
    textConstant('kFormatTitles', listed(titles(formats))),
    textConstant('kFormatNames', listed(namesOf(formats))),
    textConstant('kWrittenEndings', listed(endings(writtenFormats(formats)))),
    textConstant('kCoreTitles', listed(titles(ours), 'and')),
    `${textConstant('kCoreEndings', listed(endings(ours)))}\n`,
    '}  // namespace abflat::cli',
  ];
  return `${parts.join('\n')}\n`;
}

/** What the page writes for a format: its first kind of file. */
const exportOf = ({ precision, files }) => (precision ? files[0].ending.slice(1) : null);

/** Of the page. */
export function renderPageFormats({ formats }) {
  const rows = filesOf(formats).map(({ ending, type, pasted, ...file }) => {
    const { format } = file;
    const texts = {
      ending,
      title: titleOf(file),
      type,
      format: format.name,
      exported: exportOf(format),
    };
    const cells = Object.entries(texts).map(([key, value]) => `${key}: ${tsLiteral(value)}`);
    return `  { ${cells.join(', ')}, pasted: ${pasted ? new RegExp(pasted) : 'null'} },`;
  });
  const exported = writtenFormats(formats).map(exportOf);
  const parts = [
    TS_HEADER,
    '/** The formats that can be written, in the order in which they are offered. */',
    `export const EXPORT_FORMATS = [${exported.map(tsLiteral).join(', ')}] as const;\n`,
    'export type ExportFormat = (typeof EXPORT_FORMATS)[number];\n',
    `/** A kind of file that holds a mesh. */
export interface MeshFile {
  readonly ending: string;
  readonly title: string;
  /** For browsers and systems. */
  readonly type: string;
  readonly format: ${union(formats.map(({ name }) => name))};
  /** How a mesh of this format is exported in its own; null if it cannot be. */
  readonly exported: ExportFormat | null;
  /** How a text of the format begins. */
  readonly pasted: RegExp | null;
}
`,
    `export const MESH_FILES: readonly MeshFile[] = [\n${rows.join('\n')}\n];\n`,
    '/** What formats and their files are called. */',
    `export const MESH_NAMES = [${namesOf(formats).map(tsLiteral).join(', ')}];`,
  ];
  return `${parts.join('\n')}\n`;
}

/** The manifest of the page with the files that the system may open with it. */
export function fillManifest(text, { formats }) {
  // The page alone opens FBX.
  const rows = [...filesOf(formats), { ending: '.fbx', type: 'application/x-fbx' }]
    .map(({ ending, type }) => `        ${literal(type)}: [${literal(ending)}]`)
    .sort();
  const accept = /"accept": \{[^}]*\}/;
  if (!accept.test(text)) throw new Error('the manifest has no "accept"');
  return text.replace(accept, `"accept": {\n${rows.join(',\n')}\n      }`);
}
