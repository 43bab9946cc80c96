// Sources that can be read together, one after another, as one translation unit: clang-tidy spends
// most of its time on headers, which are then read only once.

/** The name that an unindented line declares, if any. */
function declared(line) {
  const type = line.match(/^(?:template <.*> )?(?:struct|class|union|enum(?: class)?|using) (\w+)/);
  const other = line.match(/^[\w:][^={(]*?(\w+)(?:\[[^\]]*\])*(?: =|\(|\{|;|$)/);
  return type?.[1] ?? other?.[1];
}

const namesIn = (text) => new Set(text.split('\n').map(declared).filter(Boolean));

/** Names that are local to a source: in its unnamed namespace, or static. */
export function ownNames(text) {
  const blocks = text.match(/^namespace \{$[\s\S]*?^\} {2}\/\/ namespace$/gm) ?? [];
  const statics = text.match(/^static .*$/gm) ?? [];
  return namesIn([...blocks, ...statics].join('\n'));
}

const wordsOf = (text) => new Set(text.match(/\b[A-Za-z_]\w*/g));

const share = (names, words) => [...names].some((name) => words.has(name));

/** All names that a source uses or its headers declare. */
function knownNames({ text, headers }) {
  const names = wordsOf(text);
  for (const header of headers) for (const name of namesIn(header)) names.add(name);
  return names;
}

/** What of `sources` is compiled as one already, and with the same flags. */
function unitsOf(sources) {
  const units = new Map();
  for (const source of sources) {
    const key = `${source.unit ?? source.file} ${source.flags}`;
    units.set(key, [...(units.get(key) ?? []), source]);
  }
  return [...units.values()];
}

const union = (sets) => new Set(sets.flatMap((set) => [...set]));

/**
 * Splits `sources` (`{ file, unit, text, headers, flags }`, where `headers` are the texts of all
 * headers, and `unit` names what is compiled as one, if it is) into lists of about `most`. All sources
 * of a list have the same flags, and no unit knows a name that is local to another.
 */
export function batches(sources, most) {
  const found = [];
  for (const list of unitsOf(sources)) {
    const { flags } = list[0];
    const names = union(list.map(({ text }) => ownNames(text)));
    const words = union(list.map(knownNames));
    const hasRoom = (batch) => batch.flags === flags && batch.list.length + list.length <= most;
    const agrees = (batch) => !share(names, batch.words) && !share(batch.names, words);
    let batch = found.find((each) => hasRoom(each) && agrees(each));
    if (!batch) {
      batch = { flags, list: [], names: new Set(), words: new Set() };
      found.push(batch);
    }
    batch.list.push(...list);
    for (const name of names) batch.names.add(name);
    for (const word of words) batch.words.add(word);
  }
  return found.map(({ list }) => list);
}
