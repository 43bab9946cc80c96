const MB = 2 ** 20;

export const PAGE = 65536;
/** What the module starts with: INITIAL_MEMORY in wasm/CMakeLists.txt. */
export const MIN_MEMORY = 16 * MB;
/** All that 32-bit addresses can reach. */
export const MAX_MEMORY = 4096 * MB;
/** A module never gives memory back, so a worker whose heap has grown beyond this is replaced. */
export const KEPT_MEMORY = 512 * MB;

export function megabytes(bytes: number): string {
  return `${Math.floor(bytes / MB)} MB`;
}
