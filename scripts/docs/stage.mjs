// Puts the documents, with links for the site, and their pictures into one folder.

import { cpSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { ROOT } from '../lib/paths.mjs';
import { Failure } from '../lib/run.mjs';
import { isPicture, relinked } from './links.mjs';

const { repository } = JSON.parse(readFileSync(join(ROOT, 'wasm/package.json'), 'utf8'));

/** Where sources are looked at, which are not on the site. */
export const REPOSITORY = repository.url.replace(/^git\+/, '').replace(/\.git$/, '');

export function write(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}

/** `root` is what the documents are relative to; they go to `folder`. */
export function stagePages(groups, folder, root = ROOT) {
  const pages = groups.flatMap((group) => group.pages);
  const places = new Map(pages.map(({ file, place }) => [file, place]));
  const pictures = new Map();
  for (const { file, place } of pages) {
    const targetOf = (path) => {
      if (!existsSync(join(root, path)))
        throw new Failure(`${file} links to ${path}, which does not exist.`);
      if (places.has(path)) return places.get(path);
      if (!isPicture(path)) return `${REPOSITORY}/tree/main/${path}`;
      const name = `pictures/${basename(path)}`;
      if ((pictures.get(name) ?? path) !== path)
        throw new Failure(`${path} and ${pictures.get(name)} have the same name: rename one.`);
      pictures.set(name, path);
      return name;
    };
    const text = readFileSync(join(root, file), 'utf8');
    write(join(folder, place), relinked(text, file, place, targetOf));
  }
  for (const [name, path] of pictures) cpSync(join(root, path), join(folder, name));
}
