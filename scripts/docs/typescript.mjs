// The reference of the npm package, from the comments of its sources.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Application, Comment, ReflectionKind } from 'typedoc';
import { ROOT } from '../lib/paths.mjs';
import { readSchema } from '../lib/read-schema.mjs';
import { Failure } from '../lib/run.mjs';
import { fullText, ofPackage, optionSets, pascalCase } from '../lib/schema.mjs';

/** The entry points that have types, and their sources: ['abflat/three', 'wasm/src/three.ts']. */
export function entryPoints() {
  const { name, exports } = JSON.parse(readFileSync(join(ROOT, 'wasm/package.json'), 'utf8'));
  return Object.entries(exports)
    .filter(([, conditions]) => conditions.types)
    .map(([path, { types }]) => [
      `${name}${path.slice(1)}`,
      types.replace('./dist/', 'wasm/src/').replace(/\.d\.ts$/, '.ts'),
    ]);
}

/** What each option does, by the interface that has it: "UnwrapOptionValues.padding". */
function optionTexts() {
  const sets = optionSets(ofPackage(readSchema(ROOT)));
  const texts = sets.flatMap(({ verb, options }) =>
    options.map((option) => [
      `${pascalCase(verb)}OptionValues.${option.name}`,
      `${fullText(option)}. Default: \`${option.default}\`.`,
    ]),
  );
  return new Map(texts);
}

/** The generated interfaces have no comments, which would make the package larger. */
function describeOptions(project) {
  const texts = optionTexts();
  for (const property of project.getReflectionsByKind(ReflectionKind.Property)) {
    const { parent, name } = property.inheritedFrom?.reflection ?? property;
    const text = texts.get(`${parent?.name}.${name}`);
    if (text && !property.comment) property.comment = new Comment([{ kind: 'text', text }]);
  }
}

/** Writes one page for each entry point into `folder`; returns the pages, relative to it. */
export async function writeTypeScriptReference(folder) {
  const points = entryPoints();
  const app = await Application.bootstrapWithPlugins({
    entryPoints: points.map(([, source]) => join(ROOT, source)),
    tsconfig: join(ROOT, 'wasm/tsconfig.json'),
    plugin: ['typedoc-plugin-markdown'],
    router: 'module',
    readme: 'none',
    name: 'JavaScript reference',
    // Its default is docs/, which it would empty first.
    out: folder,
    logLevel: 'Warn',
    // The build of the package checks the types.
    skipErrorChecking: true,
    excludeInternal: true,
    excludePrivate: true,
    excludeExternals: true,
    disableSources: true,
    githubPages: false,
    hidePageHeader: true,
    hideBreadcrumbs: true,
    useCodeBlocks: true,
    sort: ['kind', 'alphabetical'],
    parametersFormat: 'table',
    interfacePropertiesFormat: 'table',
    typeAliasPropertiesFormat: 'table',
    enumMembersFormat: 'table',
    typeDeclarationVisibility: 'compact',
    validation: { notExported: false, invalidLink: true, notDocumented: false },
  });
  const project = await app.convert();
  if (!project || app.logger.hasErrors())
    throw new Failure('TypeDoc could not read the sources of the npm package, see above.');
  for (const module of project.children ?? [])
    module.name =
      points.find(([, source]) => source.endsWith(`/${module.name}.ts`))?.[0] ?? module.name;
  describeOptions(project);
  await app.outputs.writeOutput({ name: 'markdown', path: folder }, project);
  if (app.logger.hasErrors())
    throw new Failure('TypeDoc could not write the reference of the npm package, see above.');
  return points.map(([name]) => name);
}
