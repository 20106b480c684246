// mdBook's preprocessor of this book: reads the book from the standard input, writes it with equations and figures drawn, links
// to files of the repository led to their pages, and cases and notebooks added as pages.
//
// mdBook's protocol: https://rust-lang.github.io/mdBook/for_developers/preprocessors.html

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { caseChapters } from "./cases.mjs";
import { architectureChapters, exampleChapter } from "./code.mjs";
import { drawFigures } from "./figures.mjs";
import { leadLinks } from "./links.mjs";
import { drawMath } from "./math.mjs";
import { notebookChapters } from "./notebooks.mjs";

if (process.argv[2] === "supports") {
  process.exit(process.argv[3] === "html" ? 0 : 1);
}

const [context, book] = JSON.parse(readFileSync(0, "utf8"));
const root = join(context.root, "..");

/** The pages that are added below a page of the book. */
const added = {
  "gallery.md": caseChapters,
  "python.md": notebookChapters,
  "extending.md": exampleChapter,
  "api.md": architectureChapters,
};

/** Draws a chapter and those below it. */
function draw(chapter) {
  const steps = [(text, path) => leadLinks(text, path, root), drawFigures(root), drawMath];
  for (const step of steps) {
    chapter.content = step(chapter.content, chapter.path);
  }
  chapters(chapter.sub_items).forEach(draw);
}

/** The chapters among the items of a book, without headings and lines. */
function chapters(items) {
  return items.flatMap((item) => (item.Chapter ? [item.Chapter] : []));
}

try {
  for (const chapter of chapters(book.items)) {
    const below = added[chapter.path]?.(root, chapter) ?? [];
    // Numbers are not shown; by their lengths the contents are folded.
    below.forEach((Chapter, place) => chapter.sub_items.push({ Chapter: { ...Chapter, number: [...chapter.number, place + 1] } }));
    draw(chapter);
  }
} catch (problem) {
  console.error(`error: ${problem.message}`);
  process.exit(1);
}
process.stdout.write(JSON.stringify(book));
