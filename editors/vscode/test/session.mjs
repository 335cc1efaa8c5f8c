// A session in VS Code itself: code-server in headless Chromium. Opens a design, types a mistake and looks for what the
// editor shows: the squiggle under the right word, a hover, a completion, a rename, a quick fix. Every step leaves a picture.
//   node session.mjs URL FOLDER_OF_THE_DESIGN FOLDER_OF_PICTURES
import fs from "node:fs";
import path from "node:path";
import { createRequire } from "node:module";
const [url, folder, pictures] = process.argv.slice(2);
const { chromium } = createRequire(path.join(process.cwd(), "package.json"))("playwright-core");

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const page = await browser.newPage({ viewport: { width: 1300, height: 850 } });
let failed = 0;
const step = async (name, act) => {
  const began = Date.now();
  try {
    await act();
    console.log(`ok      ${name} (${Date.now() - began} ms)`);
  } catch (fault) {
    failed += 1;
    console.log(`FAILED  ${name}: ${String(fault.message).split("\n")[0]}`);
    console.log("        marks:", await page.$$eval("[class*=squiggly]", (marks) => marks.map((mark) => mark.className)));
  }
  await page.screenshot({ path: `${pictures}/${name.replaceAll(" ", "-")}.png` });
};
const press = (key) => page.keyboard.press(key);
const palette = async (words) => {
  await press("F1");
  await page.waitForSelector(".quick-input-widget input", { state: "visible" });
  await page.keyboard.type(words);
  await page.waitForTimeout(600);
  await press("Enter");
};
// Puts the caret on a line and column, both from 1.
const go = async (line, column) => {
  await press("Control+G");
  await page.waitForSelector(".quick-input-widget input", { state: "visible" });
  await page.keyboard.type(`${line}:${column}`);
  await press("Enter");
  await page.waitForTimeout(400);
};
const save = async (holds) => {
  await press("Control+S");
  for (let tries = 0; tries < 30; tries += 1) {
    if (holds(fs.readFileSync(path.join(folder, "vault.ifs"), "utf8"))) return;
    await page.waitForTimeout(100);
  }
  throw new Error("the saved text is not what was expected");
};

await page.goto(`${url}/?folder=${folder}&payload=[["openFile","vscode-remote://${new URL(url).host}${folder}/vault.ifs"]]`);
await step("open", async () => {
  await page.waitForSelector(".monaco-workbench .explorer-folders-view", { timeout: 60000 });
  await page.waitForSelector(".monaco-editor .view-line", { timeout: 30000 });
  await page.click(".monaco-editor .view-line");
  await page.waitForSelector(".statusbar-item >> text=ifs", { timeout: 20000 });
});
await step("error under the word", async () => {
  await go(16, 18);
  await press("F8");
  await page.waitForSelector(".squiggly-error", { state: "attached", timeout: 20000 });
  // Where the squiggle is, in columns of the line it lies on.
  const marked = await page.evaluate(() => {
    const mark = document.querySelector(".squiggly-error").getBoundingClientRect();
    const middle = mark.top + mark.height / 2;
    const line = [...document.querySelectorAll(".view-line")].find((line) => {
      const box = line.getBoundingClientRect();
      return box.top <= middle && middle < box.bottom;
    });
    const spans = [...(line?.querySelectorAll("span span") ?? [])];
    const under = (span) => {
      const box = span.getBoundingClientRect();
      return box.left < mark.right - 2 && mark.left + 2 < box.right;
    };
    return { text: spans.filter(under).map((span) => span.textContent).join(""), width: mark.width };
  });
  if (!marked.text.includes("spann")) throw new Error(`the squiggle is under: ${JSON.stringify(marked)}`);
  await press("Escape");
});
await step("quick fix", async () => {
  const [line, column] = [16, 18];
  await go(line, column);
  await press("Control+.");
  await page.waitForSelector(".action-widget .monaco-list-row", { timeout: 10000 });
  await page.screenshot({ path: `${pictures}/quick-fix-menu.png` });
  await press("Enter");
  await page.waitForTimeout(800);
  await save((text) => !text.includes("spann"));
});
await step("hover", async () => {
  await go(7, 8);
  await palette("Show or Focus Hover");
  await page.waitForSelector(".monaco-hover:not(.hidden) .hover-contents", { timeout: 10000 });
  const text = await page.textContent(".monaco-hover:not(.hidden)");
  if (!text.includes("Length")) throw new Error(`the hover says: ${text}`);
  await page.screenshot({ path: `${pictures}/hover-shown.png` });
  await press("Escape");
});
await step("completion", async () => {
  await go(8, 1);
  await press("End");
  await press("Enter");
  await page.keyboard.type("let twice = 2 * spa");
  await press("Control+Space");
  try {
    await page.waitForSelector(".suggest-widget.visible .monaco-list-row", { timeout: 10000 });
    const labels = (rows) => rows.map((row) => row.getAttribute("aria-label") ?? "");
    const rows = await page.$$eval(".suggest-widget.visible .monaco-list-row", labels);
    if (!rows.some((row) => /^span\b/.test(row))) throw new Error(`offered: ${rows.join("; ")}`);
    await page.screenshot({ path: `${pictures}/completion-shown.png` });
  } finally {
    // The line goes again, for the steps that follow.
    await press("Escape");
    await press("Control+Shift+K");
  }
});
await step("rename", async () => {
  await go(7, 8);
  await press("F2");
  await page.waitForSelector(".rename-box input", { state: "visible", timeout: 10000 });
  await page.screenshot({ path: `${pictures}/rename-box.png` });
  // The box may be seen before keys go to it.
  await page.fill(".rename-box input", "opening");
  await page.press(".rename-box input", "Enter");
  await page.waitForTimeout(1200);
  await save((text) => text.includes("param opening") && text.includes("0.1 * opening"));
});
await step("report", async () => {
  await palette("ifs: Show Report");
  await page.waitForSelector(".webview.ready", { timeout: 60000 });
  await page.waitForTimeout(2500);
});
await step("preview of outputs above the block", async () => {
  await page.click(".tab >> text=vault.ifs");
  await palette("View: Hide Panel");
  await go(27, 1);
  const lens = page.locator(".codelens-decoration a", { hasText: "preview outputs of vault" });
  await lens.first().waitFor({ state: "visible", timeout: 20000 });
  await page.screenshot({ path: `${pictures}/lenses.png` });
  await lens.first().click({ timeout: 20000 });
  await page.waitForSelector(".quick-input-widget .monaco-list-row", { state: "visible", timeout: 60000 });
  await page.screenshot({ path: `${pictures}/outputs-offered.png` });
  await page.keyboard.type("labels.svg");
  await page.waitForTimeout(500);
  await press("Enter");
  await page.waitForSelector(".tab >> text=labels.svg", { timeout: 20000 });
  await page.waitForTimeout(2000);
});
await browser.close();
console.log(failed === 0 ? "VS Code: every step succeeded" : `VS Code: ${failed} steps failed`);
process.exit(failed === 0 ? 0 : 1);
