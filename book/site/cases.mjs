// The published cases as pages: what is said of each, and its file.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

import { chapter } from "./chapter.mjs";

/** A page for each folder of `cases`, by title. */
export function caseChapters(root, parent) {
  const folder = join(root, "cases");
  const names = readdirSync(folder).filter((name) => existsSync(join(folder, name, "case.toml")));
  const pages = names.map((name) => {
    const about = readFileSync(join(folder, name, "README.md"), "utf8").trimEnd();
    const text = readFileSync(join(folder, name, "case.toml"), "utf8").trimEnd();
    const written = `Write it out with \`archard new ${name}\`:`;
    return chapter(`${about}\n\n## The case\n\n${written}\n\n\`\`\`toml\n${text}\n\`\`\`\n`, `cases/${name}.md`, parent);
  });
  return pages.sort((one, other) => one.name.localeCompare(other.name, "en"));
}
