/// Set by the build.
declare const __WASM_BYTES__: number;
declare const __WORDS__: Readonly<Record<string, string>> | 'pseudo' | null;

declare module '@module/knotwork.js' {
  const createKnotwork: import('./bridge').ModuleFactory;
  export default createKnotwork;
}
