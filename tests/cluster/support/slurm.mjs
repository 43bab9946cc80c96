// A Slurm of one node, with a munge of its own, on loopback.

import { spawn, spawnSync } from 'node:child_process';
import { randomBytes } from 'node:crypto';
import {
  chmodSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { cpus, hostname, tmpdir } from 'node:os';
import { join } from 'node:path';
import { freePort, run, until } from './batches.mjs';

const TOOLS = ['slurmctld', 'slurmd', 'munged', 'sbatch', 'scontrol'];
const SEARCH = { ...process.env, PATH: `${process.env.PATH}:/usr/sbin:/sbin` };
const missing = TOOLS.filter((tool) => spawnSync('which', [tool], { env: SEARCH }).status !== 0);

/** Slurm's daemons change users, so they run as root. */
export const withoutSlurm =
  missing.length > 0
    ? `there is no ${missing.join(', no ')}`
    : process.getuid?.() === 0
      ? false
      : 'Slurm is only started by root';

const configOf = ({ folder, controlPort, nodePort }) => `
ClusterName=test
SlurmctldHost=${hostname()}(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=${folder}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmctldPort=${controlPort}
SlurmdPort=${nodePort}
SlurmctldPidFile=${folder}/slurmctld.pid
SlurmdPidFile=${folder}/slurmd.pid
StateSaveLocation=${folder}/state
SlurmdSpoolDir=${folder}/spool
SlurmctldLogFile=${folder}/slurmctld.log
SlurmdLogFile=${folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MinJobAge=3600
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
NodeName=${hostname()} NodeAddr=127.0.0.1 CPUs=${cpus().length} RealMemory=8192 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
`;

/** Starts one; resolves to { run, node, end }. `run` takes a command and its arguments. */
export async function startSlurm() {
  // Sockets have short names.
  const folder = mkdtempSync(join(tmpdir(), 'slurm-'));
  const daemons = [];
  const start = (program, ...args) => {
    const child = spawn(program, args, { env, stdio: ['ignore', 'pipe', 'pipe'] });
    let said = '';
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (data) => (said += data));
    daemons.push({ child, said: () => `${program}: ${said}` });
  };
  const config = join(folder, 'slurm.conf');
  const env = { ...SEARCH, SLURM_CONF: config, SBATCH_ARGS: '--mem=1G --cpus-per-task=1' };
  for (const name of ['state', 'spool']) mkdirSync(join(folder, name));
  writeFileSync(join(folder, 'munge.key'), randomBytes(128));
  for (const [name, mode] of [
    ['munge.key', 0o600],
    ['.', 0o755],
  ])
    chmodSync(join(folder, name), mode);
  writeFileSync(
    config,
    configOf({ folder, controlPort: await freePort(), nodePort: await freePort() }),
  );
  const files = ['key', 'pid', 'seed', 'log'].map(
    (what) => `--${what}-file=${folder}/munge.${what}`,
  );
  start('munged', '--foreground', '--force', `--socket=${folder}/munge.socket`, ...files);
  const logs = () =>
    [
      ...daemons.map(({ said }) => said()),
      ...['slurmctld.log', 'slurmd.log']
        .map((name) => join(folder, name))
        .filter(existsSync)
        .map((path) => readFileSync(path, 'utf8').slice(-2000)),
    ].join('\n');
  const end = async () => {
    for (const { child } of daemons.reverse()) {
      if (child.exitCode !== null) continue;
      const closed = new Promise((resolve) => child.on('close', resolve));
      child.kill('SIGTERM');
      await closed;
    }
    rmSync(folder, { recursive: true, force: true });
  };
  const call = (command, ...args) => run(command, args, { env });
  try {
    await until(() => existsSync(`${folder}/munge.socket`), 'munge', 30);
    start('slurmctld', '-D');
    start('slurmd', '-D');
    await until(
      async () => /idle/.test((await call('sinfo', '-h', '-o', '%t')).stdout),
      'the node',
      60,
    );
  } catch (error) {
    const said = logs();
    await end();
    throw new Error(`${error.message}\n${said}`);
  }
  return { run: call, node: hostname(), logs, end };
}
