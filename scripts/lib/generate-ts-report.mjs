// The structs of reports in TypeScript.

import { lateSets, TS_HEADER, union } from './generate-ts.mjs';
import { isIn, isNullable, PLAIN_TYPES, typesOf } from './report-schema.mjs';
import { ofPackage, pascalCase, sentence } from './schema.mjs';

/** One file with an interface for each struct of the package. */
export function renderReportTypes(schema) {
  const types = typesOf(schema);
  const shared = sharedNames(schema);
  const parts = schema.structs
    .filter((struct) => isIn(struct, 'package'))
    .map((struct) => interfaceText(struct, types, shared));
  const text = parts.join('\n');
  const imports = [...shared].filter((name) => new RegExp(`: ${name}\\b`).test(text)).sort();
  return `${TS_HEADER}\n${importLines(schema, imports)}\n${text}`;
}

/** What reports use of the files of options that load late, and of generated.ts. */
function importLines(schema, names) {
  const late = new Map(
    lateSets(schema).map(({ verb }) => [`${pascalCase(verb)}OptionValues`, `generated-${verb}`]),
  );
  const fileOf = (name) => late.get(name) ?? 'generated';
  return [...new Set(names.map(fileOf))]
    .sort()
    .map((file) => {
      const used = names.filter((name) => fileOf(name) === file);
      const list =
        used.length === 1 ? ` ${used[0]} ` : `\n${used.map((n) => `  ${n},\n`).join('')}`;
      return `import type {${list}} from './${file}.js';\n`;
    })
    .join('');
}

/** The names that generated.ts defines. */
function sharedNames(schema) {
  const known = typesOf(ofPackage(schema));
  return new Set([...known].filter(([, type]) => type.names || type.options).map(([name]) => name));
}

function interfaceText(struct, types, shared) {
  const fields = struct.fields.filter((field) => isIn(field, 'package'));
  const lines = fields.map((field) => {
    const unit = field.unit ? `, in ${field.unit}` : '';
    const isNull = isNullable(field, 'package') ? `; null ${field.null}` : '';
    const comment = sentence(`${field.text}${unit}${isNull}`);
    return `  /** ${comment} */\n  ${field.name}: ${tsType(field, types, shared)};`;
  });
  const base = struct.extends ? ` extends ${struct.extends}` : '';
  return `/** ${sentence(struct.text)} */\nexport interface ${struct.name}${base} {\n${lines.join('\n')}\n}\n`;
}

function tsType(field, types, shared) {
  if (field.nullFields) return `Record<keyof ${field.type}, number | null>`;
  const base = baseType(field, types, shared);
  if (field.list) return `${base}[]`;
  return isNullable(field, 'package') && field.type !== 'group' ? `${base} | null` : base;
}

function baseType(field, types, shared) {
  if (field.type === 'group') {
    const members = field.fields.map(
      (member) => `${member.name}: ${tsType(member, types, shared)}`,
    );
    return `{ ${members.join('; ')} }`;
  }
  const { packageNames } = types.get(field.type);
  if (packageNames && !shared.has(field.type)) return union(packageNames);
  return PLAIN_TYPES[field.type]?.ts ?? field.type;
}
