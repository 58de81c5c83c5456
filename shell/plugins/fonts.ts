import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import subsetFont from 'subset-font';
import type { Mathematics } from './mathematics';

/// Fonts are cut down to the characters that the page shows, at build time. Inter comes as two TrueType files, as Dear
/// ImGui reads them; the page takes the same two, so that they are fetched once. The others are woff2.

type Axes = Record<string, number | { min: number; max: number; default?: number }>;

interface Face {
  family: string;
  file: string;    ///< the file made
  source: string;  ///< package and file that it is made from
  text: string;
  weight: string;
  style?: 'normal' | 'italic';
  axes?: Axes;
  features?: string[];
}

const ascii = String.fromCharCode(...Array.from({ length: 95 }, (_, i) => 32 + i));
/// What C++ may write on the stage or into labels and notices.
const stageSymbols = '\u00a0°·−×±÷→←↑↓↔–—…‘’“”′″₀₁₂₃₄₅₆₇₈₉⁰¹²³⁴⁵⁶⁷⁸⁹₋⁻∞πΣΔαβγδθκλμρστφω≤≥≠≈√∂∈éèüöäøåßÅØ';

/// KaTeX's fonts, and the classes whose presence says that one is in use.
const mathematicsFonts: [file: string, family: string, weight: string, style: 'normal' | 'italic', classes: string[]][] =
  [
    ['Main-Regular', 'KaTeX_Main', '400', 'normal', []],
    ['Math-Italic', 'KaTeX_Math', '400', 'italic', []],
    ['Main-Bold', 'KaTeX_Main', '700', 'normal', ['mathbf', 'textbf']],
    ['Main-Italic', 'KaTeX_Main', '400', 'italic', ['mathit', 'textit']],
    ['Size1-Regular', 'KaTeX_Size1', '400', 'normal', ['delimsizing size1', 'op-symbol small-op', 'delim-size1']],
    ['Size2-Regular', 'KaTeX_Size2', '400', 'normal', ['delimsizing size2', 'op-symbol large-op']],
    ['Size3-Regular', 'KaTeX_Size3', '400', 'normal', ['delimsizing size3']],
    ['Size4-Regular', 'KaTeX_Size4', '400', 'normal', ['delimsizing size4', 'delim-size4']],
    ['AMS-Regular', 'KaTeX_AMS', '400', 'normal', ['amsrm', 'mathbb']],
    ['Caligraphic-Regular', 'KaTeX_Caligraphic', '400', 'normal', ['mathcal']],
  ];

/// `pageText` is all that the page says, `italicText` what of it is in italics.
export async function makeFonts(
  directory: string,
  pageText: string,
  italicText: string,
  mathematics: Mathematics,
): Promise<void> {
  await mkdir(directory, { recursive: true });
  const text = unique(ascii + pageText + '“”‘’–—…·×−');
  const serif = '@fontsource-variable/source-serif-4/files/source-serif-4-latin-opsz';
  const inter = 'inter-ui/variable/InterVariable.woff2';
  const textFeatures = ['kern', 'liga', 'onum'];  // what prose.css asks for
  const faces: Face[] = [
    {
      family: 'Source Serif 4 Variable', file: 'serif.woff2', source: `${serif}-normal.woff2`, text, weight: '400 650',
      axes: { wght: { min: 400, max: 650 }, opsz: 20 }, features: textFeatures,
    },
    {
      family: 'Source Serif 4 Variable', file: 'serif-italic.woff2', source: `${serif}-italic.woff2`,
      text: unique(italicText), weight: '400', style: 'italic', axes: { wght: 400, opsz: 16 }, features: textFeatures,
    },
  ];
  for (const [file, family, weight, style, classes] of mathematicsFonts) {
    if (classes.length > 0 && !classes.some((name) => mathematics.uses(name))) continue;
    faces.push({
      family, file: `katex-${file}.woff2`, source: `katex/dist/fonts/KaTeX_${file}.woff2`,
      text: mathematics.characters(family), weight, style, features: [],
    });
  }
  for (const [weight, range] of [[400, '400'], [600, '500 700']] as const) {
    faces.push({
      family: 'Inter', file: `stage-${weight}.ttf`, source: inter, text: unique(text + stageSymbols), weight: range,
      // Kerning is 3 KB: a few words in semibold do without.
      axes: { wght: weight, opsz: 14 }, features: weight === 400 ? ['kern', 'tnum'] : ['tnum'],
    });
  }
  await Promise.all(faces.map((face) => makeFace(directory, face)));
  await writeFile(join(directory, 'fonts.css'), faces.map(rule).join(''));
}

const formatOf = (face: Face): 'woff2' | 'truetype' => (face.file.endsWith('.ttf') ? 'truetype' : 'woff2');

async function makeFace(directory: string, face: Face): Promise<void> {
  const path = createRequire(import.meta.url).resolve(face.source);
  const cut = await subsetFont(await readFile(path), face.text, {
    targetFormat: formatOf(face),
    preserveNameIds: [0, 13, 14],  // copyright and licence stay in the file
    noHinting: true,  // for screens so coarse that few are left
    ...(face.axes ? { variationAxes: face.axes } : {}),
    ...(face.features ? { keepFeatures: face.features } : {}),
  });
  await writeFile(join(directory, face.file), cut);
}

function rule(face: Face): string {
  return (
    `@font-face{font-family:'${face.family}';font-style:${face.style ?? 'normal'};font-weight:${face.weight};` +
    `font-display:swap;src:url('./${face.file}') format('${formatOf(face)}')}\n`
  );
}

export function unique(text: string): string {
  return [...new Set(text)].filter((character) => character >= ' ').sort().join('');
}
