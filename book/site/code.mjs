// Pages on the code: how its crates fit together, and an example.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { chapter } from "./chapter.mjs";

/** The page on the architecture. */
export function architectureChapter(root, parent) {
  return [chapter(readFileSync(join(root, "ARCHITECTURE.md"), "utf8"), "architecture.md", parent)];
}

/** The example of a wear law from outside. */
export function exampleChapter(root, parent) {
  const name = "custom_wear_law";
  const code = readFileSync(join(root, `crates/archard/examples/${name}.rs`), "utf8").trimEnd();
  const page = `# A wear law of your own\n\n\`cargo run -p archard --example ${name}\`:\n\n\`\`\`rust,ignore\n${code}\n\`\`\`\n`;
  return [chapter(page, `examples/${name}.md`, parent)];
}
