// The pictures of the pages in the docs, made anew: ADIT_PROGRAM=... ADIT_SOURCE=... node screenshots.mjs FOLDER, in the folder
// that the phase `see` has furnished (build/pages). On a machine with nothing else to do, or the pages show that.
import { spawnSync } from "node:child_process";
import { join, resolve } from "node:path";
import { closeBrowser, openBrowser, openPage, run, scratch, serve, source, until } from "./browser.mjs";

const folder = resolve(process.argv[2]);
const pause = seconds => new Promise(r => setTimeout(r, 1000 * seconds));
const frames = page => page.locator("#foot").textContent().then(text => Number(text.match(/(\d+) frames/)?.[1] ?? 0));
async function shoot(page, name) {
  const path = join(folder, name);
  await page.screenshot({ path });
  await page.context().close();
  spawnSync("convert", [path, "+dither", "-colors", "240", "PNG8:" + path]);  // half the bytes; left as it is without ImageMagick
}

await openBrowser();
const at = scratch();
process.chdir(at.folder);  // pages show the names that the program was given
await run("fly", "s_bend", "--time", "20", "--quiet", "--report", "bend.html");
const report = await openPage("file://" + join(at.folder, "bend.html"), { width: 1180, height: 1180 });
await report.getByRole("slider", { name: "Frame" }).focus();
for (let page = 0; page < 8; ++page) await report.keyboard.press("PageUp");
await report.evaluate(() => document.activeElement.blur());
await pause(2);
await shoot(report, "report.png");

await run("render", "s_bend", "--frames", "12", "--size", "320x240", "--out", "bend", "--quiet");
await run("eval", "bend", "--method", "paper,adit", "--gallery", "gallery.html", "--quiet");
const gallery = await openPage("file://" + join(at.folder, "gallery.html"), { width: 1180, height: 1050 });
await gallery.evaluate(() => scrollTo(0, document.getElementById("h-frames").offsetTop - 90));
await pause(1);
await shoot(gallery, "gallery.png");

process.chdir(source);
const view = await serve("view", "data/clip.avi", "--loop");
const live = await openPage(view.address, { width: 1180, height: 1100 });
await pause(15);
await shoot(live, "view.png");
await view.end();

const flight = await serve("fly", "s_bend", "--view", "--time", "20", "--quiet");
const flown = await openPage(flight.address, { width: 1180, height: 1000 });
await until(async () => await frames(flown) > 240, "it flies for 8 s", 300);
await shoot(flown, "fly_view.png");
await flight.end();
at.remove();
await closeBrowser();
