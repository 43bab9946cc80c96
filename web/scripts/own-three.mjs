// Vite plugin for workers: what reads FBX has a copy of three.js. If it shared one with what edits seams, that would be loaded with
// all that an FBX needs.

const READER = /\/(FBXLoader|NURBSCurve|NURBSUtils|fbx-[\w-]+)\.[jt]s(\?|$)/;

/** @returns {import('vite').Plugin} */
export const ownThree = () => ({
  name: 'abflat-own-three',
  apply: 'build',
  enforce: 'pre',
  async resolveId(source, importer) {
    if (source !== 'three' || !READER.test(importer ?? '')) return undefined;
    const whole = await this.resolve(source, importer, { skipSelf: true });
    return `${whole?.id.replace('.module.', '.core.')}?fbx`;
  },
});
