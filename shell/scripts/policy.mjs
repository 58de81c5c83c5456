// The content security policy, in one place: the built page carries it as a <meta>, the server sends it as a header.
// WebAssembly may be compiled; nothing else may be evaluated, and nothing comes from another origin. The mathematics
// needs no inline styles: the build turns KaTeX's style attributes into classes.
export const policy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' data:",
  "font-src 'self'",
  "connect-src 'self'",
  "object-src 'none'",
  "base-uri 'self'",
  "form-action 'none'",
].join('; ');
