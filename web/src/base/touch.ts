/** Whether the page is used by fingers, perhaps without keys. */
export const isTouch = (): boolean => window.matchMedia('(pointer: coarse)').matches;
