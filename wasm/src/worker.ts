// Entry of the Web Worker that runs every module; `workerUrl` points to it.

import { simd } from './glue-simd.js';
import { threads } from './glue-threads.js';
import { serveWeb } from './serve-web.js';
import { startsAny } from './start-any.js';

serveWeb(startsAny({ simd, threads }));
