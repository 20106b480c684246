// What mdBook's pages leave out, put into each of them: a link past the navigation, the first that the keyboard reaches.

import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const SKIP = '<a class="skip" href="#mdbook-content">Skip to the text</a>';

const site = process.argv[2];
for (const file of readdirSync(site, { recursive: true })) {
  if (!file.endsWith(".html") || file.startsWith("api")) continue;
  const page = readFileSync(join(site, file), "utf8");
  // The frame of the contents, for browsers without scripts, is no page.
  if (!page.includes('id="mdbook-content"')) continue;
  writeFileSync(join(site, file), page.replace("<body>", `<body>\n    ${SKIP}`));
}
