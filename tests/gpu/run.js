// Runs shader_check in this page; the lines that it prints are in window.results once it has ended.
import create from './shader_check.js';

const lines = [];
await create({ print: (line) => lines.push(line) });
window.results = lines.map((line) => JSON.parse(line));
