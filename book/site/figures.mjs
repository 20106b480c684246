// Figures of the book: drawings put into the page, where they take the colours of its theme.
//
// A drawing is one SVG file in `book/src/figures`. By itself, as on GitHub, it follows the colours of the system by the style
// that it has; in the page it loses this style and takes that of `site.css`.

import { readFileSync } from "node:fs";
import { join, posix } from "node:path";

import { escaped, outsideCode } from "./markdown.mjs";

const FIGURE = /^!\[([^\]]*)\]\((\S*figures\/[\w-]+\.svg)\)$/gm;

/** What draws the figures of a page, the book's folder being below `root`. */
export function drawFigures(root) {
  return (text, path) =>
    outsideCode(text, (part) =>
      part.replace(FIGURE, (_, seen, file) => {
        if (!seen) throw new Error(`${path}: ${file}: say in brackets what the figure shows`);
        const drawing = readFileSync(join(root, "book/src", posix.dirname(path), file), "utf8");
        const inside = drawing
          .replace(/<style>[\s\S]*?<\/style>/, "")
          .replace(/<svg\b/, `<svg role="img" aria-label="${escaped(seen)}"`)
          .replace(/\n\s*/g, "\n");
        return `<figure class="drawing">\n${inside.trim()}\n</figure>`;
      }),
    );
}
