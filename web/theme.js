// Before the first paint, so that no wrong theme flashes. A file of its own: a page without inline scripts can be served with a strict
// content security policy.
const isLight = matchMedia('(prefers-color-scheme: light)').matches;
let theme = isLight ? 'light' : 'dark';
try {
  theme = localStorage.getItem('abflat-theme') || theme;
} catch (error) {
  console.info('The theme cannot be remembered:', error.message);
}
document.documentElement.dataset.theme = theme;
