// Entry of a Web Worker for every build: what `workerUrl` names.

import { plain } from './glue-plain.js';
import { simd } from './glue-simd.js';
import { threads } from './glue-threads.js';
import { serveWeb } from './serve-web.js';

serveWeb({ plain, simd, threads });
