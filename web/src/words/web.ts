// Meshes from the web.

/** Why nothing is fetched from an address. */
export const ADDRESSES = {
  password: (host: string) =>
    `The address of the mesh on ${host} contains a password, so it was not opened. Download the file, then open it.`,
  notHttps: (address: string) =>
    `${address} was not opened, because it does not begin with https://. Use an https address, or download the file.`,
  invalid: (text: string) => `"${text}" is not an address. Check the link.`,
};

/** Meshes from the web. Sizes are in bytes. */
export const FETCHING = {
  started: (name: string, host: string) => `Fetching ${name} from ${host}`,
  progress: (name: string, received: number, total: number | null) => {
    const size = (bytes: number) => (bytes / 1e6).toFixed(1);
    return `Fetching ${name}: ${size(received)}${total === null ? '' : ` of ${size(total)}`}\u202fMB`;
  },
  tooManyNamed: (found: number, most: number) =>
    `The mesh refers to ${found} other files, but at most ${most} can be fetched. Download all of them, then open the folder.`,
};
