import { remember, remembered } from './remember';

/** Also read by public/theme.js, which sets the theme before the first paint. */
const KEY = 'abflat-theme';

const root = document.documentElement;

/** Makes a button switch the theme; `changed` is also called when the system's theme changes and at once. */
export function bindTheme(button: HTMLButtonElement, changed: () => void): void {
  const other = () => (root.dataset.theme === 'light' ? 'dark' : 'light');
  const use = (theme: string) => {
    root.dataset.theme = theme;
    button.setAttribute('aria-label', `Use the ${other()} theme`);
    button.title = `Use the ${other()} theme`;
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
