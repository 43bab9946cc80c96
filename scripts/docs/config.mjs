// How VitePress builds the site. A link that leads nowhere ends the build.

import { slugOf } from './links.mjs';

const linkOf = (place) => `/${place.replace(/(^|\/)index\.md$/, '$1').replace(/\.md$/, '.html')}`;

const itemsOf = (pages) => pages.map(({ place, title }) => ({ text: title, link: linkOf(place) }));

const withoutCode = (text, env, markdown) =>
  markdown.render(text.replace(/^ *```.*?^ *```$/gms, ''), env);

/**
 * `groups`: see pages.mjs; `references`: further pages, `{ place, title }`, and `{ address, title }`
 * for what VitePress has not made.
 */
export function siteConfig({ groups, references, base, repository }) {
  const made = references.filter(({ place }) => place);
  const others = references.filter(({ address }) => address);
  return {
    title: 'abflat',
    description: 'UV layouts of any mesh, checked exactly',
    lang: 'en',
    base,
    ignoreDeadLinks: false,
    head: [['link', { rel: 'icon', type: 'image/svg+xml', href: `${base}icon.svg` }]],
    // In the file itself, a forge would show it as a table.
    transformPageData: ({ relativePath }) =>
      relativePath === 'index.md' ? { frontmatter: { pageClass: 'start', aside: false } } : {},
    markdown: { anchor: { slugify: slugOf } },
    vite: {
      logLevel: 'warn',
      // The index of the search is one file.
      build: { chunkSizeWarningLimit: 4000 },
    },
    themeConfig: {
      // Code is not searched: to highlight it once more would take as long as all pages.
      search: { provider: 'local', options: { _render: withoutCode } },
      outline: { level: [2, 3] },
      logo: '/icon.svg',
      nav: [
        { text: 'Start', link: '/' },
        { text: 'Command line', link: '/command-line.html' },
        { text: 'JavaScript', link: '/javascript.html' },
        { text: 'Python', link: '/python.html' },
        { text: 'C++', link: '/cpp.html' },
      ],
      sidebar: [
        ...groups.map(({ title, isFolded, pages }) => ({
          text: title,
          collapsed: isFolded,
          items: itemsOf(pages),
        })),
        {
          text: 'References',
          items: [
            ...itemsOf(made),
            ...others.map(({ title, address }) => ({
              text: title,
              link: address,
              target: '_self',
            })),
          ],
        },
      ],
      socialLinks: [{ icon: 'github', link: repository }],
    },
  };
}
