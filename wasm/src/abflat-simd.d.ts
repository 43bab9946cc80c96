// The module that Emscripten writes.

import type { NativeSettings } from './glue.js';
import type { NativeModule } from './native-module.js';

export default function createNative(settings: NativeSettings): Promise<NativeModule>;
