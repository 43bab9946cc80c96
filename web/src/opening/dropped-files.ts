import { CHOSEN_FILES } from '../words/opening';

/** Nobody needs more for a mesh and its textures: it would be a whole disk. */
const MOST_FILES = 1000;

/** The dropped files, including those in dropped folders. */
export async function filesOf(dropped: DataTransfer): Promise<File[]> {
  // Right away: dropped items can only be read in this task.
  const plain = [...dropped.files];
  const entries = [...dropped.items].map((item) => item.webkitGetAsEntry());
  if (!entries.some((entry) => entry?.isDirectory)) return plain;
  const files: File[] = [];
  for (const entry of entries) if (entry) await gather(entry, files);
  if (files.length === 0) throw new Error(CHOSEN_FILES.emptyFolder);
  return files;
}

/** Hidden files in a folder belong to the system, even if they are named like meshes. */
async function gather(entry: FileSystemEntry, files: File[]): Promise<void> {
  if (entry.name.startsWith('.')) return;
  if (isFile(entry)) files.push(await fileOf(entry));
  else if (isFolder(entry)) for (const inner of await entriesOf(entry)) await gather(inner, files);
  if (files.length > MOST_FILES) throw new Error(CHOSEN_FILES.tooMany(MOST_FILES));
}

const isFile = (entry: FileSystemEntry): entry is FileSystemFileEntry => entry.isFile;
const isFolder = (entry: FileSystemEntry): entry is FileSystemDirectoryEntry => entry.isDirectory;

const fileOf = (entry: FileSystemFileEntry) =>
  new Promise<File>((resolve, reject) => {
    entry.file(resolve, reject);
  });

/** A reader returns some entries at a time, and none once there are no more. */
async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((resolve, reject) => {
      reader.readEntries(resolve, reject);
    });
    if (some.length === 0) return all;
    all.push(...some);
  }
}
