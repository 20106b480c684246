// Pages on the code: how its crates fit together, and an example.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { chapter } from "./chapter.mjs";

/** The pages on the architecture and on how single parts work. */
export function architectureChapters(root, parent) {
  const page = (name) => chapter(readFileSync(join(root, `${name.toUpperCase()}.md`), "utf8"), `${name}.md`, parent);
  return ["architecture", "parts"].map(page);
}

/** The example of a wear law from outside. */
export function exampleChapter(root, parent) {
  const name = "custom_wear_law";
  const code = readFileSync(join(root, `crates/archard/examples/${name}.rs`), "utf8").trimEnd();
  const page = `# A wear law of your own\n\n\`cargo run -p archard --example ${name}\`:\n\n\`\`\`rust,ignore\n${code}\n\`\`\`\n`;
  return [chapter(page, `examples/${name}.md`, parent)];
}
