// Meshes from the web.

/** Everything that is asked in a sheet of its own. */
export const QUESTION = { cancel: 'Cancel' };

/** Asked before anything is fetched. Sizes come as texts. */
export const WEB_SHEET = {
  openFrom: (name: string, host: string) => `Open ${name} from ${host}?`,
  /** `size`: '' if it is not known. */
  whatHappens: (host: string, size: string, namesFiles: boolean) =>
    `Your browser fetches this mesh${size && ` (${size})`}${namesFiles ? ' and the files it refers to' : ''} from ${host}, which sees your IP address. Your own meshes never leave your machine.`,
  open: 'Open',
  fetchLarge: (size: string) => `Fetch ${size}?`,
  large: (name: string, size: string) =>
    `${name} is larger than most meshes: ${size} or more. Fetching and unwrapping it may take a long time.`,
  fetch: 'Fetch',
  megabytes: (size: string) => `${size}\u202fMB`,
};

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

/** Why fetching failed. */
export const FETCH_FAILED = {
  empty: (name: string, host: string) =>
    `${name} at ${host} is empty. Check the address, or ask who published it.`,
  webPage: (name: string, host: string) =>
    `${host} sent a web page instead of ${name}. Use the address of the file itself.`,
  offline: (name: string, host: string) =>
    `${name} could not be fetched from ${host}, because there is no network connection. Connect, then open it again.`,
  unreachable: (name: string, host: string) =>
    `${name} could not be fetched from ${host}: the server cannot be reached, or does not allow other sites to read the file (CORS). Download the file, then open it.`,
  notThere: (name: string, host: string, status: number) =>
    `${host} has no ${name} (${status}). Check the address.`,
  notAllowed: (name: string, host: string, status: number) =>
    `${host} requires you to sign in for ${name} (${status}). Sign in there, download the file, then open it.`,
  refused: (name: string, host: string, status: number) =>
    `${host} did not send ${name} (${status}). Try again later, or download the file and open it.`,
  interrupted: (name: string) => `The connection was lost while fetching ${name}. Open it again.`,
};
