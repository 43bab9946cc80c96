// Entry of the Web Worker for the build `threads`.

import { threads } from './glue-threads.js';
import { serveWeb } from './serve-web.js';
import { starts } from './starts.js';

serveWeb(starts({ threads }));
