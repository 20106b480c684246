// Links and pictures of the pages of a site, from their text.

import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { join, posix } from "node:path";

/** How many pages there are, and what is wrong with them. Pages made by rustdoc and pdoc are only led to. */
export function checkLinks(site) {
  const files = readdirSync(site, { recursive: true }).filter((file) => file.endsWith(".html"));
  const pages = files.filter((file) => !file.startsWith("api/"));
  const faults = pages.flatMap((page) => faultsOf(site, page));
  return { pages: pages.length, faults };
}

function faultsOf(site, page) {
  const text = read(site, page);
  const faults = [];
  if (!/<html[^>]* lang="en"/.test(text)) faults.push(`${page}: <html> has no lang`);
  // The frame with the contents, for browsers without scripts, has no text to go to.
  if (page !== "toc.html" && !text.includes('class="skip"')) faults.push(`${page}: no link past the navigation`);
  for (const [picture] of text.matchAll(/<img\b[^>]*>/g)) {
    if (!/\balt="[^"]+"/.test(picture)) faults.push(`${page}: ${picture}: no alt that says what is seen`);
  }
  for (const [, target] of text.matchAll(/\b(?:href|src)="([^"]*)"/g)) {
    const trouble = gone(site, page, target.replaceAll("&amp;", "&"));
    if (trouble) faults.push(`${page}: ${target}: ${trouble}`);
  }
  return faults;
}

/** What is wrong with a target of a page, if anything is. */
function gone(site, page, target) {
  if (/^(https?:|mailto:|data:|javascript:)/.test(target)) return null;
  const [path, place] = target.split("#");
  // The page for addresses that are not there is shown at any address.
  const folder = page === "404.html" ? "." : posix.dirname(page);
  let file = path === "" ? page : posix.join(folder, decodeURIComponent(path.split("?")[0]));
  if (page === "404.html" && path.startsWith("/")) file = path.slice(1);
  if (!existsSync(join(site, file))) return "no such file";
  if (statSync(join(site, file)).isDirectory()) file = posix.join(file, "index.html");
  if (!existsSync(join(site, file))) return "a folder without a page";
  if (!place || !file.endsWith(".html")) return null;
  return ids(site, file).has(decodeURIComponent(place)) ? null : "no such place on the page";
}

const texts = new Map();
function read(site, file) {
  if (!texts.has(file)) texts.set(file, readFileSync(join(site, file), "utf8"));
  return texts.get(file);
}

const places = new Map();
function ids(site, file) {
  if (!places.has(file)) {
    const found = read(site, file).matchAll(/\b(?:id|name)="([^"]*)"/g);
    places.set(file, new Set(Array.from(found, ([, id]) => id)));
  }
  return places.get(file);
}
