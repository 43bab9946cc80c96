// The reference of the C++ library, from the comments of its public headers, by Doxygen.

import { spawnSync } from 'node:child_process';
import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from '../lib/paths.mjs';
import { Failure, which } from '../lib/run.mjs';
import { write } from './stage.mjs';

const INCLUDE = join(ROOT, 'core/include');

function settings(folder, mainPage) {
  const version = readFileSync(join(INCLUDE, 'abflat/version.h'), 'utf8').match(/"([\d.]+)"/)?.[1];
  return {
    PROJECT_NAME: 'abflat',
    PROJECT_BRIEF: 'UV layouts, checked exactly',
    PROJECT_NUMBER: version,
    INPUT: [join(INCLUDE, 'abflat'), mainPage],
    STRIP_FROM_PATH: INCLUDE,
    STRIP_FROM_INC_PATH: INCLUDE,
    OUTPUT_DIRECTORY: folder,
    HTML_OUTPUT: '.',
    RECURSIVE: true,
    GENERATE_LATEX: false,
    GENERATE_TREEVIEW: true,
    JAVADOC_AUTOBRIEF: true,
    BUILTIN_STL_SUPPORT: true,
    EXTRACT_ALL: true,
    EXTRACT_LOCAL_CLASSES: false,
    HIDE_UNDOC_RELATIONS: false,
    HAVE_DOT: false,
    MACRO_EXPANSION: true,
    EXPAND_ONLY_PREDEF: true,
    PREDEFINED: 'ABFLAT_API=',
    SHOW_INCLUDE_FILES: false,
    SORT_MEMBER_DOCS: false,
    MARKDOWN_SUPPORT: true,
    AUTOLINK_SUPPORT: true,
    HTML_TIMESTAMP: false,
    QUIET: true,
    WARNINGS: true,
    WARN_IF_UNDOCUMENTED: false,
    WARN_IF_INCOMPLETE_DOC: false,
  };
}

/** The first page, in the words of Doxygen, which links names of headers. */
const MAIN_PAGE = `/** \\mainpage Public headers
These headers are all that a program includes.

Begin with abflat/unwrap.h for any mesh, abflat/flatten.h for one disk, abflat/pack_layout.h for a
layout that is there already, and abflat/io.h for files. abflat/mesh.h and abflat/mesh_view.h have
meshes, abflat/status.h what functions return. abflat/abflat.h is for C.

<a href="../cpp.html">How to add the library to a project</a> is in the documents. */
`;

function settingText(value) {
  if (typeof value === 'boolean') return value ? 'YES' : 'NO';
  return [value]
    .flat()
    .map((part) => JSON.stringify(part))
    .join(' ');
}

/** Writes pages of HTML into `folder`; returns why not, if Doxygen is not installed. */
export function writeCppReference(folder) {
  const doxygen = which('doxygen');
  if (doxygen === undefined)
    return 'Doxygen is not installed (on Debian: apt-get install doxygen), so the reference of the C++ headers is left out.';
  // Beside the folder, which is for what Doxygen writes.
  const mainPage = `${folder}.dox`;
  write(mainPage, MAIN_PAGE);
  const input = Object.entries(settings(folder, mainPage))
    .map(([name, value]) => `${name} = ${settingText(value)}\n`)
    .join('');
  const { status, stderr } = spawnSync(doxygen, ['-'], { cwd: ROOT, input, encoding: 'utf8' });
  rmSync(mainPage);
  if (status !== 0) throw new Failure(`Doxygen failed:\n${stderr}`);
  if (stderr.trim() !== '') console.warn(stderr.trim());
  return undefined;
}
