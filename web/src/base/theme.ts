import { THEME } from '../words/base';
import { remember, remembered } from './remember';

/** theme.js, beside index.html, also reads it, to set the theme before the first paint. */
const KEY = 'abflat-theme';

const root = document.documentElement;

/**
 * Makes a button switch the theme. `changed` is called at once and also when the system's theme
 * changes.
 */
export function bindTheme(button: HTMLButtonElement, changed: () => void): void {
  const other = () => (root.dataset.theme === 'light' ? 'dark' : 'light');
  const use = (theme: string) => {
    root.dataset.theme = theme;
    button.setAttribute('aria-label', THEME.use(other()));
    button.title = THEME.use(other());
    colorFrame();
    changed();
  };
  button.addEventListener('click', () => {
    use(other());
    remember(KEY, root.dataset.theme ?? '');
  });
  window.matchMedia('(prefers-color-scheme: light)').addEventListener('change', (event) => {
    if (!remembered(KEY)) use(event.matches ? 'light' : 'dark');
  });
  use(root.dataset.theme ?? 'dark');
}

/** The window of an installed page, or the browser around it, goes on with the bar. */
function colorFrame(): void {
  const color = getComputedStyle(root).getPropertyValue('--panel');
  for (const meta of document.querySelectorAll<HTMLMetaElement>('meta[name="theme-color"]'))
    meta.content = color;
}
