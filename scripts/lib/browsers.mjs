// Browsers that test files use one after the other: starting one costs as much as several pages.

/**
 * The jobs of nodeJobs, each with a browser of its own while it runs. `serve` starts one, as
 * serveBrowser does. All are closed when the last job is done.
 */
export function withBrowsers(jobs, serve) {
  const idle = [];
  let left = jobs.length;
  const isUsable = (browser) => browser.process().exitCode === null;
  const runIn = async (job) => {
    const browser = idle.pop() ?? (await serve());
    try {
      return await job.run({ ABFLAT_BROWSER: browser.wsEndpoint() });
    } finally {
      if (isUsable(browser)) idle.push(browser);
      left -= 1;
      if (left === 0) await Promise.all(idle.map((each) => each.close()));
    }
  };
  return jobs.map((job) => ({ name: job.name, run: () => runIn(job) }));
}
