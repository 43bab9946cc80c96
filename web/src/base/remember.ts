/** What the page knew of itself at an earlier visit; null: nothing, or storage is off. */
export function remembered(key: string): string | null {
  try {
    return localStorage.getItem(key);
  } catch (error) {
    console.info(`${key} cannot be read:`, error);
    return null;
  }
}

export function forget(key: string): void {
  try {
    localStorage.removeItem(key);
  } catch (error) {
    console.info(`${key} cannot be forgotten:`, error);
  }
}

export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(key, value);
  } catch (error) {
    // Storage is off or full: it still holds for this visit.
    console.info(`${key} cannot be remembered:`, error);
  }
}
