// The notebooks of the Python package as pages: text, code, and what the code has given and drawn.
//
// Notebooks are kept without output. A test runs them and leaves those with output in the folder of the environment variable
// ARCHARD_NOTEBOOKS; where it is not set, pages have the code alone and say so.

import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { chapter } from "./chapter.mjs";

/** A page for each notebook. */
export function notebookChapters(root, parent) {
  const folder = join(root, "python/notebooks");
  const pictures = join(root, "target/site-notebooks");
  const files = readdirSync(folder).filter((file) => file.endsWith(".ipynb")).sort();
  return files.map((file) => {
    const run = process.env.ARCHARD_NOTEBOOKS && join(process.env.ARCHARD_NOTEBOOKS, file);
    const has = Boolean(run && existsSync(run));
    const notebook = JSON.parse(readFileSync(has ? run : join(folder, file), "utf8"));
    const name = file.replace(".ipynb", "");
    const keep = (picture, data) => {
      mkdirSync(pictures, { recursive: true });
      writeFileSync(join(pictures, picture), Buffer.from(data, "base64"));
    };
    const parts = notebook.cells.flatMap((cell, place) => written(cell, `${name}-${place}`, file, keep));
    const note = has ? [] : ["*This build of the site has not run the notebook: pictures and numbers are left out.*"];
    const end = `The notebook: \`python/notebooks/${file}\`.`;
    return chapter([parts[0], ...note, ...parts.slice(1), end].join("\n\n") + "\n", `notebooks/${name}.md`, parent);
  });
}

/** A cell in Markdown. */
function written(cell, name, file, keep) {
  const source = [cell.source].flat().join("");
  if (cell.cell_type === "markdown") return [source];
  const parts = [`\`\`\`python\n${source}\n\`\`\``];
  (cell.outputs ?? []).forEach((output, place) => {
    const picture = output.data?.["image/png"];
    const text = output.text ?? output.data?.["text/plain"];
    if (picture) {
      const seen = cell.metadata?.alt;
      if (!seen) throw new Error(`${file}: the cell ${name} draws a picture: say in its metadata, as "alt", what is seen`);
      const drawn = `${name}-${place}.png`;
      keep(drawn, [picture].flat().join(""));
      parts.push(`<img src="${drawn}" alt="${seen.replaceAll('"', "&quot;")}">`);
    } else if (text) {
      parts.push(`\`\`\`text\n${[text].flat().join("").trimEnd()}\n\`\`\``);
    }
  });
  return parts;
}
