// Vite plugin for workers: the transcoder of Basis Universal makes functions of texts, which the policy of the page forbids.
// Functions that do the same take their place.

const FILE = /\/basis_transcoder\.js$/;

const INVOKER =
  /let\[args,invokerFnBody\]=createJsInvoker\([^)]*\);args\.push\(invokerFnBody\);var invokerFn=newFunc\(Function,args\)\(\.\.\.closureArgs\);/;

/** A function that C++ offers. */
const invoker = `var invokerFn=function(...given){
  if(given.length!==argCount-2)throwBindingError('function '+humanName+' called with '+given.length+' arguments, expected '+(argCount-2));
  const destructors=needsDestructorStack?[]:null;
  const first=isClassMethodFunc?1:2;
  const wired=isClassMethodFunc?[argTypes[1].toWireType(destructors,this)]:[];
  for(const[i,value]of given.entries())wired.push(argTypes[i+2].toWireType(destructors,value));
  const returned=cppInvokerFunc(cppTargetFunc,...wired);
  if(needsDestructorStack)runDestructors(destructors);
  else for(let i=first;i<argTypes.length;++i)if(argTypes[i].destructorFunction!==null)argTypes[i].destructorFunction(wired[i-first]);
  if(returns)return argTypes[0].fromWireType(returned);
};`;

const CALLER = /newFunc\(Function,params\)\(\.\.\.args\)/;

/** A method of JavaScript that C++ calls. */
const caller = `(object,func,destructorsRef,at)=>{
  const given=types.map((type)=>{const value=type.readValueFromPointer(at);at+=type.argPackAdvance;return value;});
  const returned=kind===1?new func(...given):kind===0?func.call(object,...given):func.call(...given);
  if(!retType.isVoid)return emval_returnValue(retType,destructorsRef,returned);
}`;

/** @returns {import('vite').Plugin} */
export const withoutEval = () => ({
  name: 'abflat-without-eval',
  apply: 'build',
  enforce: 'pre',
  transform(source, id) {
    if (!FILE.test(id)) return undefined;
    if (!INVOKER.test(source) || !CALLER.test(source))
      throw new Error(
        'basis_transcoder.js is written in another way now: change without-eval.mjs.',
      );
    return {
      code: source.replace(INVOKER, () => invoker).replace(CALLER, () => caller),
      map: null,
    };
  },
});
