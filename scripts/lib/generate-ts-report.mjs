// The structs of reports in TypeScript.

import { TS_HEADER, union } from './generate-ts.mjs';
import { isIn, isNullable, PLAIN_TYPES, typesOf } from './report-schema.mjs';
import { ofPackage, sentence } from './schema.mjs';

/** One file with an interface for each struct of the package. */
export function renderReportTypes(schema) {
  const types = typesOf(schema);
  const shared = sharedNames(schema);
  const parts = schema.structs
    .filter((struct) => isIn(struct, 'package'))
    .map((struct) => interfaceText(struct, types, shared));
  const text = parts.join('\n');
  const imports = [...shared].filter((name) => new RegExp(`: ${name}\\b`).test(text)).sort();
  const lines = imports.map((name) => `  ${name},`).join('\n');
  return `${TS_HEADER}\nimport type {\n${lines}\n} from './generated.js';\n\n${text}`;
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
