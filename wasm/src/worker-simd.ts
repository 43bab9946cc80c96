// Entry of the Web Worker for the build `simd`.

import { simd } from './glue-simd.js';
import { serveWeb } from './serve-web.js';
import { starts } from './starts.js';

serveWeb(starts({ simd }));
