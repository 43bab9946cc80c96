// What options are for. No first layout needs it.

import { loadPart } from '../base/load-part';

export const optionTexts = () => loadPart(import('../words/generated-option-texts'));
