// Tests the built site: node book/site/check.mjs target/site
//
// Every page: links and pictures lead to files and places that are there, pictures say what is seen, the page names its language and
// has the link past the navigation. Some pages in Chromium, on a telephone and on a desk, in both themes: nothing complains on the
// console, nothing is wider than the window, and axe-core finds no fault (contrast, names, order of headings, keyboard).

import { checkPages } from "./check/browser.mjs";
import { checkLinks } from "./check/links.mjs";

const site = process.argv[2];
if (!site) {
  console.error("usage: node book/site/check.mjs SITE");
  process.exit(2);
}
const { pages, faults } = checkLinks(site);
const seen = await checkPages(site);
const all = [...faults, ...seen.faults];
for (const fault of all) console.error(`error: ${fault}`);
console.log(`${pages} pages, ${seen.views} views in a browser, ${all.length} faults`);
process.exit(all.length === 0 ? 0 : 1);
