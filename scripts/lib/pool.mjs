// Runs the jobs of several suites in parallel, and shows each suite in one piece.

/**
 * Runs `suites` (`{ title, jobs, waits }`), at most `slots` jobs at a time and in order, so that
 * the first jobs of one suite fill the gaps left by the last ones of another. Jobs of a suite that
 * mostly `waits` run one at a time beside the others, and use their slots once those are done. Those
 * of a suite that `repeats` the tests of another come last; one that would begin once `isLate` is
 * skipped instead, and says so. A job is `{ name, run }`; `run` resolves to `{ passed, failed, skipped,
 * output }`. `show` is called with each suite when it is complete: `{ title, parts }`, where a part
 * holds a job's name, result and seconds. Resolves to all of these in the order of the suites.
 */
export async function runPool(suites, slots, show, isLate = () => false) {
  const records = suites.map(({ title, jobs }) => ({
    title,
    parts: new Array(jobs.length),
    left: jobs.length,
  }));
  const all = suites.flatMap(({ jobs }, suite) => jobs.map((job, part) => ({ job, suite, part })));
  const last = all.filter(({ suite }) => suites[suite].repeats);
  const beside = all.filter(({ suite }) => suites[suite].waits);
  const others = all.filter(({ suite }) => !suites[suite].waits && !suites[suite].repeats);
  const work = async (...queues) => {
    const take = () => queues.find((queue) => queue.length > 0)?.shift();
    for (let next = take(); next !== undefined; next = take()) {
      const record = records[next.suite];
      const isOut = suites[next.suite].repeats && isLate();
      record.parts[next.part] = isOut ? leftOut(next.job) : await timed(next.job);
      record.left -= 1;
      if (record.left === 0) show(record);
    }
  };
  const lanes = Array.from({ length: slots }, () => work(others, beside, last));
  if (others.length > 0) lanes.push(work(beside));
  await Promise.all(lanes);
  return records;
}

function leftOut({ name }) {
  const output = `${name}: skipped for lack of time. Another suite runs the same tests.\n`;
  return { name, passed: 0, failed: 0, skipped: 1, output, seconds: 0, isLeftOut: true };
}

async function timed({ name, run }) {
  const started = performance.now();
  const result = await run();
  return { name, ...result, seconds: (performance.now() - started) / 1000 };
}
