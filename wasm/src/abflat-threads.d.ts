// The same module with threads.

import type { NativeSettings } from './glue.js';
import type { NativeModule } from './native-module.js';

export default function createNative(settings: NativeSettings): Promise<NativeModule>;
