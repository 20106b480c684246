// Equations, $...$ and $$...$$, drawn by KaTeX when the book is built.
//
// The same text is read by GitHub, whose Markdown takes backslashes before signs away and takes underscores after signs for
// emphasis. An equation that would suffer by that is refused here.

import katex from "katex";

import { escaped, outsideCode } from "./markdown.mjs";

const EQUATION = /\$\$([\s\S]+?)\$\$|\$(?!\s)([^$\n]+?)(?<!\s)\$(?!\d)([.,;:]?)/g;
const UNREADABLE = [
  [/\\[^a-zA-Z\s]/, "a backslash before a sign: write \\lbrace, \\thinspace, \\lVert or \\cr"],
  [/[^a-zA-Z0-9\s\\]_/, "an underscore after a sign: put a letter before it"],
  [/\*/, "a star: write \\ast"],
];

/** The page's text with its equations drawn. */
export function drawMath(text, path) {
  return outsideCode(text, (part) =>
    part.replace(EQUATION, (_, display, inline, stop) =>
      display === undefined ? draw(inline, stop, false, path) : draw(display.trim(), "", true, path),
    ),
  );
}

/** An equation with the stop behind it, so that no line begins with that. */
function draw(tex, stop, displayMode, path) {
  for (const [pattern, trouble] of UNREADABLE) {
    if (pattern.test(tex)) {
      throw new Error(`${path}: "${tex}": GitHub does not read ${trouble}`);
    }
  }
  let drawn;
  try {
    const stopped = stop ? `${tex}\\text{${stop}}` : tex;
    drawn = katex.renderToString(stopped, { displayMode, output: "htmlAndMathml", strict: "error", throwOnError: true });
  } catch (problem) {
    throw new Error(`${path}: "${tex}": ${problem.message}`);
  }
  // What stands between tags is text for Markdown, and a row of a table is one line.
  return drawn.replaceAll("\n", " ").replace(/>([^<]+)</g, (_, between) => `>${escaped(unescaped(between))}<`);
}

/** What KaTeX writes by name, as it reads. */
function unescaped(text) {
  const named = { amp: "&", lt: "<", gt: ">", quot: '"', "#x27": "'" };
  return text.replace(/&(amp|lt|gt|quot|#x27);/g, (_, name) => named[name]);
}
