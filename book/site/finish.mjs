// What mdBook's pages leave out, put into each of them:
//
// - a link past the navigation, the first that the keyboard reaches;
// - the button of the contents as one, and names for the pictures that a click enlarges;
// - the themes whose contrast is tested, and no others.

import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const CHANGES = [
  ["<body>", '<body>\n    <a class="skip" href="#mdbook-content">Skip to the text</a>'],
  ['<label id="mdbook-sidebar-toggle"', '<label id="mdbook-sidebar-toggle" role="button" tabindex="0"'],
  [/<li role="none"><button role="menuitem" class="theme" id="mdbook-theme-(rust|coal|ayu)">.*?<\/li>\s*/g, ""],
  [">Navy</button>", ">Dark</button>"],
  [/<input class="checkbox-img" type="checkbox"/g, '$& aria-label="Enlarge the picture"'],
];

const site = process.argv[2];
for (const file of readdirSync(site, { recursive: true })) {
  if (!file.endsWith(".html") || file.startsWith("api/")) continue;
  const page = readFileSync(join(site, file), "utf8");
  // The frame of the contents, for browsers without scripts, is no page.
  if (!page.includes('id="mdbook-content"')) continue;
  writeFileSync(join(site, file), CHANGES.reduce((text, [from, to]) => text.replace(from, to), page));
}
