// What the page's scripts say to people is in one folder.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import ts from 'typescript';
import { ROOT } from '../../scripts/lib/paths.mjs';

const SOURCES = join(ROOT, 'web/src');
const FOLDER = 'words/';

const FILES = {
  'files/baked-gltf-obj.ts': 'keywords of OBJ and MTL',
  'files/baked-obj-glb.ts': 'keywords of MTL',
  'files/mtl.ts': 'keywords of MTL',
  'files/svg-text.ts': 'writes SVG',
};

/** How errors begin that only a developer can meet. */
const ERRORS = {
  'base/dom.ts': ['The page has no '],
  'export/export-mesh.ts': ['The result came without '],
  'seams/seam-model.ts': ['Seams are edited before '],
  'view/stage.ts': ['This browser has no WebGL 2.', 'The canvas must be in the page.'],
  'visit/visit-record.ts': ['no settings', 'no files'],
};

/** Words that are names: of keys, a status, a kind of data, a compression, the value of an option. */
const NAMES = new Set(
  [
    'Escape Enter Space Tab Home End Delete Backspace Ctrl Control Shift Alt Meta',
    'Ok Files Draco auto',
  ].flatMap((names) => names.split(' ')),
);

/** A key with Alt. */
const ALT_KEY = /^alt [\p{L}\u25a1]$/u;

/** Calls whose arguments nobody reads. */
const UNREAD = new Set(
  'querySelector querySelectorAll closest matches matchMedia element add toggle remove'.split(' '),
);
/** Properties whose values nobody reads. */
const UNREAD_PROPERTIES = new Set(['className', 'class', 'font']);
/** Properties and attributes whose values are read, even if they are a single small word. */
const READ = new Set('textContent title ariaLabel aria-label placeholder alt'.split(' '));

/** Stands for a value in a template. */
const VALUE = '\u25a1';

const WORDS = [
  /(?<![\p{L}\d-])\p{L}[\p{L}’'-]*\p{L}[,;:.?!]* \p{L}+/u,
  /\u25a1[,;:.]? \p{L}{3}/u,
  /(?<![\p{L}\d-])\p{L}{3,}[,;:]? \u25a1/u,
  /^[,;:.] \p{L}{3}/u,
  /^\p{Lu}\p{Ll}{2,}[:.,]? /u,
];

const isName = (text) => NAMES.has(text) || ALT_KEY.test(text);

const isWords = (text) =>
  WORDS.some((pattern) => pattern.test(text)) || /^\p{Lu}\p{Ll}+[.!?…]?$/u.test(text);

const isText = (node) => ts.isStringLiteralLike(node) || ts.isTemplateExpression(node);

function textOf(node) {
  if (ts.isStringLiteralLike(node)) return node.text;
  return node.head.text + node.templateSpans.map(({ literal }) => VALUE + literal.text).join('');
}

const calledName = ({ expression }) =>
  ts.isPropertyAccessExpression(expression) ? expression.name.text : expression.getText();

/** The call, assignment or property that a text goes into, and through which of its parts. */
function placeOf(node) {
  let [part, place] = [node, node.parent];
  while (
    ts.isConditionalExpression(place) ||
    ts.isParenthesizedExpression(place) ||
    (ts.isBinaryExpression(place) && !isAssignment(place))
  ) {
    if (ts.isConditionalExpression(place) && part === place.condition) break;
    [part, place] = [place, place.parent];
  }
  return { part, place };
}

const isAssignment = ({ operatorToken }) => operatorToken.kind === ts.SyntaxKind.EqualsToken;

/** The name of what a text is assigned to, as `title` in `button.title = text`; '' if it is not. */
function targetOf({ part, place }) {
  if (ts.isPropertyAssignment(place)) return place.initializer === part ? place.name.getText() : '';
  if (!ts.isBinaryExpression(place) || !isAssignment(place) || place.right !== part) return '';
  return ts.isPropertyAccessExpression(place.left) ? place.left.name.text : '';
}

function isUnread(node, file) {
  const { parent } = node;
  if (ts.isTypeNode(parent) || ts.isImportDeclaration(parent) || ts.isExportDeclaration(parent))
    return true;
  if (file.text.slice(node.getFullStart(), node.getStart()).includes('/* glsl */')) return true;
  const at = placeOf(node);
  if (UNREAD_PROPERTIES.has(targetOf(at))) return true;
  if (!ts.isCallExpression(at.place)) return false;
  const { expression, arguments: given } = at.place;
  if (expression.kind === ts.SyntaxKind.ImportKeyword) return true;
  if (/^console\./.test(expression.getText()) || UNREAD.has(calledName(at.place))) return true;
  return calledName(at.place) === 'create' && given.indexOf(at.part) === 1; // a class
}

/** Whether a text goes where people read it, so that any letters in it are words. */
function isRead(node) {
  const at = placeOf(node);
  if (READ.has(targetOf(at)) && ts.isBinaryExpression(at.place)) return true;
  if (!ts.isCallExpression(at.place)) return false;
  const [name, place] = [calledName(at.place), at.place.arguments.indexOf(at.part)];
  if (name === 'setAttribute') return place === 1 && READ.has(at.place.arguments[0].text);
  return (name === 'create' && place === 2) || (name === 'counted' && place > 0);
}

const hasLetters = (text) => /\p{L}{2}/u.test(text);

/** "view/aim.ts:12: 'Text'" for each text for people. */
function wordsIn(path, source) {
  const file = ts.createSourceFile(path, source, ts.ScriptTarget.Latest, true);
  const found = [];
  const visit = (node) => {
    ts.forEachChild(node, visit);
    if (!isText(node) || isUnread(node, file)) return;
    const text = textOf(node);
    if (isName(text) || !(isWords(text) || (isRead(node) && hasLetters(text)))) return;
    if (ERRORS[path]?.some((beginning) => text.startsWith(beginning))) return;
    const { line } = file.getLineAndCharacterOfPosition(node.getStart());
    found.push(`${path}:${line + 1}: ${node.getText()}`);
  };
  visit(file);
  return found;
}

test('all that scripts say to people is in one folder', () => {
  const paths = readdirSync(SOURCES, { recursive: true })
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => path.endsWith('.ts') && !path.startsWith(FOLDER) && !FILES[path]);
  assert.ok(paths.length > 100);
  const found = paths
    .sort()
    .flatMap((path) => wordsIn(path, readFileSync(join(SOURCES, path), 'utf8')));
  assert.deepEqual(found, [], `Words for people belong in ${FOLDER}:\n${found.join('\n')}`);
});

test('words for people are told from other texts', () => {
  const found = (source) => wordsIn('a.ts', source.replaceAll('@{', '${'));
  for (const source of [
    "say('Nothing was moved')",
    "say('half a ball')",
    "say('Cancelled')",
    'say(`Balance @{b}`)',
    'say(`Boundary t @{t}`)',
    'say(`@{n} charts`)',
    'say(`@{n}, uncompressed`)',
    "return isOn ? ', uncompressed' : ''",
    "throw new Error('no faces')",
    "button.title = isOn ? 'locked' : ''",
    "box.setAttribute('aria-label', 'charts')",
    "create('span', 'name', 'charts')",
    "counted(n, 'edge')",
  ])
    assert.equal(found(source).length, 1, source);
  for (const source of [
    "import { a } from './some words here'",
    "import('./Some')",
    "console.info('cannot be read:', error)",
    "const part = /* glsl */ 'void main of it'",
    "if (event.key === 'Escape') go('ArrowLeft')",
    "document.querySelector('dialog p')",
    "create('button', 'tab mesh-tab')",
    "box.className = isOn ? 'box open' : 'box'",
    "svg('g', { class: `mark @{shape}` })",
    "context.font = '12px system-ui, sans-serif'",
    "let kind: 'some words' | 'others'",
    "new Float32Array('webgl2')",
    'label.style.transform = `translate(@{x}px, @{y}px)`',
    'const file = `@{name}-uv.obj`',
    "error.name = 'NotLoaded'",
    "const actions = { 'alt h': showAll }",
    "input.placeholder = 'auto'",
  ])
    assert.deepEqual(found(source), [], source);
});
