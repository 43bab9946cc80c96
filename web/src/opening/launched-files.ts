import { CHOSEN_FILES } from '../words/opening';

/** What browsers have that open files with installed pages. */
interface LaunchQueue {
  setConsumer(consumer: (launch: { files?: readonly FileSystemFileHandle[] }) => void): void;
}

/** The files that the system opens the installed page with. */
export function bindLaunch(
  openFiles: (files: File[]) => void,
  refused: (reason: string) => void,
): void {
  const { launchQueue } = window as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files = [] }) => {
    Promise.all(files.map((file) => file.getFile())).then(openFiles, () =>
      refused(CHOSEN_FILES.unreadable),
    );
  });
}
