export const terminated = () => new DOMException('terminate() was called.', 'AbortError');
