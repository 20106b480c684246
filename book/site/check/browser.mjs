// Pages of a site in Chromium.

import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { delimiter, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

import { chromium } from "playwright-core";

const AXE = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
/** Names of the browser, as in the tests of reports. */
const NAMES = ["chromium", "chromium-browser", "google-chrome", "chrome"];
/** Pages of every kind: the first, equations, tables with pictures, a case, a notebook. */
const PAGES = ["index", "theory", "rigs", "cases/pin_on_disc", "notebooks/sliding"];
/** A telephone and a desk (px), the latter in both themes. */
const VIEWS = [
  { width: 360, colorScheme: "light" },
  { width: 1280, colorScheme: "light" },
  { width: 1280, colorScheme: "dark" },
];

/** How many views were looked at, and what is wrong with them. None where there is no browser, unless ARCHARD_BROWSER=required. */
export async function checkPages(site) {
  const executablePath = installed();
  if (!executablePath) {
    if (process.env.ARCHARD_BROWSER === "required") {
      return { views: 0, faults: [`ARCHARD_BROWSER=required, and none of ${NAMES.join(", ")} is installed`] };
    }
    console.log(`skipped: none of ${NAMES.join(", ")} is installed`);
    return { views: 0, faults: [] };
  }
  const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
  const faults = [];
  let views = 0;
  for (const { width, colorScheme } of VIEWS) {
    const context = await browser.newContext({ colorScheme, viewport: { width, height: 900 } });
    for (const name of PAGES) {
      const found = await faultsOf(context, join(resolve(site), `${name}.html`));
      faults.push(...found.map((fault) => `${name}, ${width} px, ${colorScheme}: ${fault}`));
      views += 1;
    }
    await context.close();
  }
  faults.push(...(await keyboard(browser, join(resolve(site), "index.html"))));
  await browser.close();
  return { views, faults };
}

function installed() {
  const folders = (process.env.PATH ?? "").split(delimiter);
  return NAMES.flatMap((name) => folders.map((folder) => join(folder, name))).find(existsSync);
}

/** What is wrong with a page as it is shown. */
async function faultsOf(context, file) {
  const page = await context.newPage();
  const faults = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) faults.push(`console: ${message.text()}`);
  });
  page.on("pageerror", (error) => faults.push(`script: ${error.message}`));
  page.on("requestfailed", (request) => faults.push(`not loaded: ${request.url()}`));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`asks the network for ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href, { waitUntil: "load" });
  await page.evaluate(() => document.fonts.ready);
  // The text scrolls by itself where it is too wide, so the window alone does not tell.
  const wide = await page.evaluate(() =>
    [document.documentElement, document.querySelector("#mdbook-content")].map((part) => part.scrollWidth - part.clientWidth),
  );
  if (Math.max(...wide) > 0) faults.push(`wider than the window by ${Math.max(...wide)} px`);
  await page.addScriptTag({ path: AXE });
  const { violations } = await page.evaluate(() =>
    // Of what mdBook puts around the text, only what the site changes is judged: its colours.
    window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"], resultTypes: ["violations"], preload: false }),
  );
  for (const { id, help, nodes } of violations) {
    const places = nodes.slice(0, 3).map((node) => `${node.target.join(" ")}: ${node.html.slice(0, 120)}`);
    faults.push(`${id} (${help}) at ${nodes.length} places: ${places.join(" | ")}`);
  }
  await page.close();
  return faults;
}

/** The first key press reaches the link past the navigation, which leads to the text; the slash opens the search. */
async function keyboard(browser, file) {
  const page = await browser.newPage();
  const faults = [];
  await page.goto(pathToFileURL(file).href, { waitUntil: "load" });
  await page.keyboard.press("Tab");
  const first = await page.evaluate(() => document.activeElement.className);
  if (first !== "skip") faults.push(`keyboard: Tab reaches "${first}" first, not the link past the navigation`);
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  const inside = await page.evaluate(() => document.querySelector("#mdbook-content").contains(document.activeElement));
  if (!inside) faults.push("keyboard: the link past the navigation does not lead to the text");
  await page.keyboard.press("/");
  await page.keyboard.type("creepage");
  const hits = page.locator("#mdbook-searchresults li");
  try {
    await hits.first().waitFor({ timeout: 10_000 });
  } catch {
    faults.push("search: nothing is found for creepage");
  }
  await page.close();
  return faults;
}
