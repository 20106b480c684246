// Links of the book to files of the repository, led to the pages of the site that show them.

import { existsSync } from "node:fs";
import { posix } from "node:path";

import { outsideCode } from "./markdown.mjs";

/** Which page of the site shows a file of the repository: patterns of its path, and the page's address. */
const PAGES = [
  [/^book\/src\/(.*)$/, "$1"],
  [/^cases\/(\w+)\/README\.md$/, "cases/$1.md"],
  [/^python\/notebooks\/(\w+)\.ipynb$/, "notebooks/$1.md"],
  [/^crates\/archard\/examples\/(\w+)\.rs$/, "examples/$1.md"],
  [/^ARCHITECTURE\.md$/, "architecture.md"],
  [/^PARTS\.md$/, "parts.md"],
  [/^python\/archard\/__init__\.py$/, "api/python/archard.html"],
  [/^crates\/([\w-]+)\/src\/lib\.rs$/, "api/rust/$1/index.html"],
  [/^crates\/([\w-]+)\/src\/(.*\.rs)$/, "api/rust/src/$1/$2.html"],
];

/** Where a page stands in the repository: one that was added where it was taken from, the others in the book's folder. */
function source(path) {
  if (["architecture.md", "parts.md"].includes(path)) return path.replace(/^\w+/, (name) => name.toUpperCase());
  return path.startsWith("cases/") ? path.replace(".md", "/README.md") : `book/src/${path}`;
}

/** The text of the page at `path` with its links led to pages of the site. */
export function leadLinks(text, path, root) {
  const folder = posix.dirname(source(path));
  const lead = (whole, target) => {
    if (/^[a-z]+:|^#/.test(target)) return whole;
    const [, file, heading] = /^([^#]*)(.*)$/.exec(target);
    const place = posix.join(folder, file);
    const known = PAGES.find(([pattern]) => pattern.test(place));
    if (!known || !existsSync(posix.join(root, place))) {
      throw new Error(`${path}: no page of the site shows "${target}": link to a page, or add its kind to book/site/links.mjs`);
    }
    let page = place.replace(known[0], known[1]);
    // Rust writes names of crates with underscores.
    page = page.replace(/^(api\/rust\/(?:src\/)?)([\w-]+)/, (_, start, crate) => start + crate.replaceAll("-", "_"));
    return `](${posix.relative(posix.dirname(path), page)}${heading})`;
  };
  return outsideCode(text, (part) => part.replace(/\]\(([^)\s]+)\)/g, lead));
}
