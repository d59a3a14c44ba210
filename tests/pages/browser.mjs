// A headless browser, the program, and what every test of a page asks of it.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import assert from "node:assert/strict";
import { chromium } from "playwright-core";

export const program = process.env.ADIT_PROGRAM;
export const source = process.env.ADIT_SOURCE;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

let browser;
const running = new Set();
process.on("exit", () => { for (const child of running) child.kill("SIGKILL"); });
export async function openBrowser() {
  browser = await chromium.launch({
    executablePath: process.env.ADIT_BROWSER || "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-dev-shm-usage"],
  });
}
/// Also ends programs that a failed test has left.
export const closeBrowser = () => {
  for (const child of running) child.kill("SIGKILL");
  return browser.close();
};

/// A page that collects what goes wrong in it, and what it asks of the network.
export async function openPage(address, viewport = { width: 1280, height: 900 }) {
  const context = await browser.newContext({ viewport });
  const page = await context.newPage();
  page.faults = [];
  page.asked = [];
  page.on("console", m => { if (["error", "warning"].includes(m.type())) page.faults.push(m.text()); });
  page.on("pageerror", e => page.faults.push(e.message));
  page.on("request", r => page.asked.push(r.url()));
  await page.goto(address, { waitUntil: "load" });
  return page;
}

/// Serious findings of axe-core: roles, names, labels, contrast.
export async function barriers(page) {
  // Through the debugger: the pages' own policy lets no other script in.
  await page.evaluate(axe + ";0");
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  return found.violations.map(v => `${v.id}: ${v.nodes.map(n => n.target.join(" ")).join(", ")}`);
}

export const isWiderThanScreen = page =>
  page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);

/// Share of the pixels of a canvas that are not of its first one's colour.
export const drawnShare = (page, selector) => page.evaluate(s => {
  const canvas = document.querySelector(s), c = canvas.getContext("2d");
  const p = new Uint32Array(c.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
  return p.filter(x => x !== p[0]).length / p.length;
}, selector);

export function scratch() {
  const folder = mkdtempSync(join(tmpdir(), "adit-pages-"));
  return { folder, remove: () => rmSync(folder, { recursive: true, force: true }) };
}

/// Runs the program to its end.
export function run(...args) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { stdio: ["ignore", "pipe", "pipe"] });
    let out = "", err = "";
    child.stdout.on("data", d => { out += d; });
    child.stderr.on("data", d => { err += d; });
    child.on("error", reject);
    child.on("close", code => code === 0 ? resolve(out) : reject(new Error(`adit ${args.join(" ")}: ${code}\n${err}`)));
  });
}

/// Starts a program that prints the address of its page first.
export async function serve(...args) {
  const child = spawn(program, args, { stdio: ["ignore", "pipe", "pipe"] });
  let err = "";
  child.stderr.on("data", d => { err += d; });
  running.add(child);
  const ended = new Promise(resolve => child.on("close", code => { running.delete(child); resolve(code); }));
  const address = await new Promise((resolve, reject) => {
    let out = "";
    child.stdout.on("data", d => { out += d; if (out.includes("\n")) resolve(out.split("\n")[0]); });
    child.on("close", () => reject(new Error(err)));
  });
  return {
    address,
    said: () => err,
    /// Ctrl-C; the exit code and how long it took.
    async end() {
      const begin = Date.now();
      child.kill("SIGINT");
      const code = await ended;
      return { code, seconds: (Date.now() - begin) / 1000 };
    },
  };
}

/// Waits until a question has a true answer.
export async function until(question, what, seconds = 30) {
  const end = Date.now() + 1000 * seconds;
  while (Date.now() < end) {
    if (await question()) return;
    await new Promise(r => setTimeout(r, 50));
  }
  assert.fail(`not within ${seconds} s: ${what}`);
}
