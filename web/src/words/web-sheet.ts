// Questions that are asked, and meshes from the web that are not fetched.

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
