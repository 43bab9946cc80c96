// The parts of the page that a first layout does not need.

/** Loaded when there is a layout. */
export const LATER = [
  'aiming',
  'appearance',
  'arranging',
  'bound-painting',
  'chart-tools',
  'density-painting',
  'generated-option-texts',
  'gltf-file',
  'help-groups',
  'make-surface',
  'method-table',
  'new-glb',
  'obj-parts',
  'objects-tab',
  'own-image',
  'plots',
  'saving-parts',
  'seam-painter',
  'solid',
  'stacks',
  'verify-tab',
  'writing',
];

/**
 * Resolves to the responses that bring all of them. To be called before the page is loaded, or some
 * of them may have come.
 */
export function laterParts(page) {
  const arrived = LATER.map(async (part) => {
    const isPart = (response) => response.url().includes(`/assets/${part}-`);
    const response = await page.context().waitForEvent('response', isPart);
    await response.finished();
    return response;
  });
  return Promise.all(arrived);
}
