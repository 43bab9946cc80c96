/** An image as a document holds it. */
export interface ImageFile {
  bytes: Uint8Array;
  /** `image/png`, `image/jpeg` or `image/webp`. */
  mimeType: string;
}
