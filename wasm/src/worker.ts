// Entry of the Web Worker that runs every build; `workerUrl` points to it.

import { plain } from './glue-plain.js';
import { simd } from './glue-simd.js';
import { threads } from './glue-threads.js';
import { serveWeb } from './serve-web.js';

serveWeb({ plain, simd, threads });
