// Vite plugin: leaves out the methods of three.js that nothing names. Bundlers keep all methods of a class that is used.

const THREE = /\/three\/(build|examples)\/.*\.js$/;
const WORD = /[\w$]+/g;
/** Called without being named. */
const IMPLIED = new Set(['constructor', 'toString', 'valueOf', 'toJSON', 'then', 'handleEvent']);
const FUNCTIONS = new Set(['FunctionExpression', 'ArrowFunctionExpression']);

/** The name of a method, or of a function that becomes one, which nothing but its name leads to. */
function nameOfMethod(node) {
  if (node.type === 'MethodDefinition' && !node.computed && !IMPLIED.has(node.key.name))
    return node.key.name;
  if (node.type !== 'ExpressionStatement' || node.expression.type !== 'AssignmentExpression')
    return undefined;
  const { left, right, operator } = node.expression;
  const isField = left.type === 'MemberExpression' && left.object.type === 'ThisExpression';
  if (operator !== '=' || !isField || left.computed) return undefined;
  const name = left.property.name;
  const isFunction =
    FUNCTIONS.has(right.type) || (right.type === 'Identifier' && right.name === name);
  return isFunction ? name : undefined;
}

/** Every word in names and texts below a node, without the nodes that are left out. */
function collectWords(node, words, leaveOut) {
  if (leaveOut?.(node)) return;
  if (node.type === 'Identifier' || node.type === 'PrivateIdentifier') words.add(node.name);
  const text = node.type === 'TemplateElement' ? node.value.raw : node.value;
  if (typeof text === 'string') for (const [word] of text.matchAll(WORD)) words.add(word);
  for (const part of Object.values(node).flat())
    if (typeof part?.type === 'string') collectWords(part, words, leaveOut);
}

/** The methods of a module, and into `words` what the rest of it names. */
function methodsOf(ast, words, isThree) {
  const methods = [];
  collectWords(ast, words, (node) => {
    const name = isThree ? nameOfMethod(node) : undefined;
    if (name === undefined) return false;
    const inside = new Set();
    const body = node.type === 'MethodDefinition' ? node.value : node.expression.right;
    collectWords(body, inside);
    methods.push({ name, inside, start: node.start, end: node.end });
    return true;
  });
  return methods;
}

/** Those of `methods` that neither `words` nor a method that is named names. */
function unnamed(methods, words) {
  const named = new Set(words);
  const rest = new Set(methods);
  for (let before = Number.POSITIVE_INFINITY; rest.size < before; ) {
    before = rest.size;
    for (const method of rest)
      if (named.has(method.name)) {
        for (const word of method.inside) named.add(word);
        rest.delete(method);
      }
  }
  return rest;
}

/** What is left of each text of the modules in `chunks`. */
function shortened(chunks, parse) {
  const words = new Set();
  const modules = chunks
    .flatMap((chunk) => Object.entries(chunk.modules))
    .filter(([, { code }]) => code)
    .map(([id, { code }]) => ({ code, methods: methodsOf(parse(code), words, THREE.test(id)) }));
  const all = modules.flatMap(({ methods }) => methods);
  const gone = unnamed(all, words);
  if (gone.size === 0)
    throw new Error('three.js is written in another way now: change named-methods.mjs.');
  return new Map(
    modules.map(({ code, methods }) => {
      const dropped = methods.filter((method) => gone.has(method));
      return [code, without(code, dropped)];
    }),
  );
}

const without = (code, methods) =>
  methods.reduceRight((text, { start, end }) => text.slice(0, start) + text.slice(end), code);

/** @returns {import('vite').Plugin} */
export function namedMethods() {
  let rests;
  return {
    name: 'abflat-named-methods',
    apply: 'build',
    renderStart() {
      rests = undefined;
    },
    renderChunk: {
      order: 'pre',
      handler(code, chunk, _, { chunks }) {
        const ids = Object.keys(chunk.modules).filter((id) => THREE.test(id));
        if (ids.length === 0) return undefined;
        rests ??= shortened(Object.values(chunks), (text) => this.parse(text));
        const rest = ids.reduce((text, id) => {
          const own = chunk.modules[id].code;
          return own ? text.replace(own, () => rests.get(own)) : text;
        }, code);
        return { code: rest, map: null };
      },
    },
  };
}
