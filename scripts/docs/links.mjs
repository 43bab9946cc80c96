// Links of a document, which are relative to its place in the repository, as links of the site.

import { posix } from 'node:path';

/** Code is left alone; what is around it has links, sources of pictures and pictures. */
const CODE_OR_LINK = /(^ *```.*?^ *```|`[^`\n]*`)|(\]\(|\bsrc(?:set)?=")([^()"\s]+)(?=[)"])/gms;
const PICTURE = /\.(webp|png|svg|jpe?g|gif)$/;
/** Pictures for dark pages follow the switch of the site, not only the system. */
const TWO_PICTURES =
  /<picture><source media="\(prefers-color-scheme: dark\)" srcset="([^"]+)">\s*<img src="([^"]+)" alt="([^"]*)"><\/picture>/g;

export const isPicture = (path) => PICTURE.test(path);

/**
 * The text of `file` with links for the site. `targetOf(path, anchor)` says where a path of the
 * repository leads to: a place on the site ("python.md", "pictures/spot.webp"), or an address.
 */
export function relinked(text, file, place, targetOf) {
  const linked = text.replace(CODE_OR_LINK, (whole, code, before, target) => {
    if (code !== undefined || /^([a-z]+:|#)/.test(target)) return whole;
    const [path, anchor] = target.split('#');
    const full = posix.normalize(posix.join(posix.dirname(file), path)).replace(/\/$/, '');
    const to = targetOf(full);
    const hash = anchor === undefined ? '' : `#${anchor}`;
    return `${before}${/^[a-z]+:/.test(to) ? to : between(place, to)}${hash}`;
  });
  return withTwoPictures(linked);
}

/** Relative, since that is how VitePress finds files and knows of links that lead nowhere. */
function between(from, to) {
  const path = posix.relative(posix.dirname(from), to);
  return path.startsWith('.') ? path : `./${path}`;
}

function withTwoPictures(text) {
  const oneLine = text.replace(/<picture>[\s\S]*?<\/picture>/g, (all) =>
    all.replace(/\s*\n\s*/g, ''),
  );
  return oneLine.replace(
    TWO_PICTURES,
    (_, dark, light, alt) =>
      `<img class="if-light" src="${light}" alt="${alt}"><img class="if-dark" src="${dark}" alt="${alt}">`,
  );
}

/** Anchors as GitHub and npm make them, so that links between documents work in both places. */
export function slugOf(heading) {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .trim()
    .replace(/\s/g, '-');
}
