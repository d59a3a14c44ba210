// The page of `adit eval --gallery`, as a person meets it.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { join } from "node:path";
import { barriers, closeBrowser, isWiderThanScreen, openBrowser, openPage, run, scratch, source, until } from "./browser.mjs";

const at = scratch();
const page_of = name => "file://" + join(at.folder, name);
const kFrames = 7;  // six drawn of a bend, one of data

before(async () => {
  await openBrowser();
  const frames = join(at.folder, "frames"), data = join(source, "data");
  await run("render", "s_bend", "--frames", "6", "--size", "320x240", "--out", frames, "--quiet");
  const judge = (...rest) => run("eval", data, frames, "--method", "paper,adit", "--set", "finder.cluster_count=8", "--quiet", ...rest);
  await judge("--gallery", join(at.folder, "gallery.html"));
  await judge("--gallery", join(at.folder, "folder"));
});
after(async () => { await closeBrowser(); at.remove(); });

const shown = page => page.locator(".card:not(.off)");
const picturesLoad = page => page.evaluate(async () => {
  const images = [...document.querySelectorAll(".card image")].map(image => image.href.baseVal);
  const load = url => new Promise(done => {
    const image = new Image();
    image.onload = () => done(image.naturalWidth > 0);
    image.onerror = () => done(false);
    image.src = url;
  });
  return (await Promise.all(images.map(load))).filter(Boolean).length;
});

test("loads whole, without a network and without a complaint, and says what made it", async () => {
  for (const name of ["gallery.html", "folder/index.html"]) {
    const page = await openPage(page_of(name));
    assert.equal(await page.locator(".card").count(), kFrames);
    assert.equal(await page.locator("#count").textContent(), `${kFrames} of ${kFrames} frames`);
    assert.equal(await picturesLoad(page), kFrames, name);
    assert.match(await page.locator("#summary").textContent(), /paper_k10_lloyd/);
    assert.match(await page.locator("#made").textContent(), /^adit \d/);
    assert.match(await page.locator("#command").textContent(), /^adit eval .*--gallery/);
    assert.match(await page.locator("#changed").textContent(), /finder\.cluster_count: 8/);
    assert.match(await page.locator("#settings").textContent(), /cluster_count: 8/);
    assert.deepEqual(page.asked.filter(url => !/^(file|data|blob):/.test(url)), []);
    assert.deepEqual(page.faults, []);
    await page.context().close();
  }
});

test("its own policy lets nothing out", async () => {
  const page = await openPage(page_of("gallery.html"));
  const left = await page.evaluate(() => fetch("http://127.0.0.1:9/").then(() => "answered", () => "refused"));
  assert.equal(left, "refused");
  assert.ok(page.faults.some(fault => /Content Security Policy/.test(fault)), page.faults.join("\n"));
  await page.context().close();
});

test("filters by set and verdict, and orders by the failures of a method", async () => {
  const page = await openPage(page_of("gallery.html"));
  await page.locator("#set").selectOption("frames");
  assert.equal(await shown(page).count(), 6);
  await page.locator("#set").selectOption("");
  const kinds = {};
  for (const kind of ["wrong", "right"]) {
    await page.locator("#which").selectOption(kind);
    kinds[kind] = await shown(page).count();
    assert.equal(await page.locator("#count").textContent(), `${kinds[kind]} of ${kFrames} frames`);
  }
  assert.ok(kinds.wrong + kinds.right <= kFrames && kinds.right > 0, JSON.stringify(kinds));
  await page.locator("#which").selectOption("");
  const rank = { miss: 0, answered_none: 0, refused_open: 1, not_counted: 2, refused_none: 3, hit: 4 };
  for (const method of await page.locator("#chief option").all()) {
    const value = await method.getAttribute("value");
    await page.locator("#chief").selectOption(value);
    const ranks = await page.locator(".card").evaluateAll((cards, v) => cards.map(c => c.dataset["v" + v]), value);
    assert.deepEqual(ranks.map(r => rank[r]), ranks.map(r => rank[r]).sort(), "failures first");
  }
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("answers of a method are taken off the pictures", async () => {
  const page = await openPage(page_of("gallery.html"));
  const circles = page.locator(".answer.m1:not(.off)");
  assert.ok(await circles.count() > 0);
  await page.locator("input[name=show][value='1']").uncheck();
  assert.equal(await circles.count(), 0);
  await page.locator("input[name=show][value='1']").check();
  assert.ok(await circles.count() > 0);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a picture is enlarged by a click and by the keyboard", async () => {
  const page = await openPage(page_of("gallery.html"));
  const first = page.locator(".card > button").first(), width = async () => (await first.boundingBox()).width;
  const small = await width();
  await first.click();
  await until(async () => await width() > 1.5 * small, "it is large");
  assert.equal(await first.getAttribute("aria-expanded"), "true");
  await page.keyboard.press("Escape");
  await until(async () => await width() === small, "it is small again");
  await page.locator("body").click({ position: { x: 2, y: 2 } });
  for (const press of ["n", "n"]) await page.keyboard.press(press);
  const focused = () => page.evaluate(() => document.activeElement.getAttribute("aria-label"));
  assert.equal(await focused(), await page.locator(".card > button").nth(1).getAttribute("aria-label"));
  await page.keyboard.press("Enter");
  assert.equal(await page.locator(".card.large").count(), 1);
  await page.keyboard.press("p");
  assert.equal(await focused(), await first.getAttribute("aria-label"));
  assert.match(await focused(), /^Enlarge \S+\.(jpg|png)$/);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("fits a narrow phone", async () => {
  const page = await openPage(page_of("gallery.html"), { width: 360, height: 740 });
  assert.equal(await isWiderThanScreen(page), false);
  const picture = await page.locator(".card svg").first().boundingBox();
  assert.ok(picture.width > 280 && picture.x >= 0 && picture.x + picture.width <= 360);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("is open to screen readers and keyboards (axe-core)", async () => {
  for (const scheme of ["dark", "light"]) {
    const page = await openPage(page_of("gallery.html"));
    await page.emulateMedia({ colorScheme: scheme });
    assert.deepEqual(await barriers(page), [], scheme);
    await page.context().close();
  }
});
