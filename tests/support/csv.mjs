// CSV as the program writes it: sentences are quoted, quotes doubled.

function cellsOf(line) {
  const cells = [];
  for (const [, quoted, plain] of line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g))
    cells.push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
  return cells;
}

/** Rows of a CSV text as objects with the keys of its first line. */
export function parseCsv(text) {
  const [head, ...lines] = text.trimEnd().split('\n').map(cellsOf);
  for (const cells of lines)
    if (cells.length !== head.length) throw new Error(`not ${head.length} cells: ${cells}`);
  return lines.map((cells) => Object.fromEntries(head.map((key, i) => [key, cells[i]])));
}
