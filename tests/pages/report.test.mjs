// The page of `adit report`, as a person meets it.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { barriers, closeBrowser, drawnShare, isWiderThanScreen, openBrowser, openPage, run, scratch, source, until }
  from "./browser.mjs";

const at = scratch();
const flight = "file://" + join(at.folder, "flight.html"), clip = "file://" + join(at.folder, "clip.html");

/// A flight of an hour at 30 Hz, of rows alone.
function anHour(folder) {
  const lines = ["frame,stamp_s,x_m,y_m,yaw_deg,delivery,status,confidence,u_px,v_px,sx,sy,azimuth_deg,command,yaw_rate_rad_s"];
  for (let i = 0; i < 108000; ++i) {
    const t = i / 30, sx = 0.3 * Math.sin(t / 7), lost = i % 9000 === 8999;
    lines.push(`${i},${t.toFixed(4)},${(t / 2).toFixed(3)},${(10 * Math.sin(t / 60)).toFixed(3)},${(20 * Math.cos(t / 60)).toFixed(2)},` +
      (lost ? "dropped,,,,,,,,hold,0" : `fresh,found,${(0.5 + 0.3 * Math.cos(t)).toFixed(3)},${(320 + 500 * sx).toFixed(1)},240,` +
        `${sx.toFixed(4)},0.01,${(sx * 57).toFixed(2)},steer,${(-sx).toFixed(3)}`));
  }
  mkdirSync(folder);
  writeFileSync(join(folder, "flight.csv"), lines.join("\n") + "\n");
}

/// A flight with an event of each kind that a click can go to.
function eventful(folder) {
  const lines = ["frame,stamp_s,x_m,y_m,yaw_deg,delivery,status,confidence,azimuth_deg,flags,command,yaw_rate_rad_s,manoeuvre,track,track_azimuth_deg"];
  for (let i = 0; i < 300; ++i)
    lines.push(`${i},${(i / 30).toFixed(4)},${(i / 60).toFixed(3)},0,0,${i === 250 ? "dropped,,,," : `fresh,found,0.8,5,${i >= 60 && i < 90 ? "glare" : ""}`},` +
      `steer,0.1,${i >= 200 && i < 220 ? "turn" : "follow"},${i < 150 ? "1,-20" : "2,25"}`);
  mkdirSync(folder);
  writeFileSync(join(folder, "flight.csv"), lines.join("\n") + "\n");
}

before(async () => {
  await openBrowser();
  await run("fly", "s_bend", "--time", "2", "--quiet", "--report", join(at.folder, "flight.html"));
  await run("run", join(source, "data/clip.avi"), "--method", "adit", "--quiet", "--report", join(at.folder, "clip.html"));
});
after(async () => { await closeBrowser(); at.remove(); });

const row = page => page.locator("#row").inputValue().then(Number);
const settled = (page, text) => until(async () => (await page.locator("#at").textContent()).includes(text), text);

test("loads whole, without a network and without a complaint", async () => {
  const page = await openPage(flight);
  await settled(page, "frame 1 of 60");
  await until(async () => await drawnShare(page, "#picture") > 0.5, "the frame is drawn");
  await until(async () => await drawnShare(page, "#map") > 0.02, "the map is drawn");
  assert.equal(await page.locator("#stages canvas").count(), 6);
  await until(async () => await drawnShare(page, "#stages figure:nth-child(4) canvas") > 0.2, "the stages are drawn");
  assert.ok(await page.locator("#charts canvas").count() >= 4);
  assert.match(await page.locator("#made").textContent(), /^adit \d/);
  assert.match(await page.locator("#changed").textContent(), /flight\.time_max_s: 2/);
  assert.deepEqual(page.asked.filter(url => !/^(file|data|blob):/.test(url)), []);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("the scrubber goes by keyboard, and says where it is", async () => {
  const page = await openPage(clip);
  const slider = page.getByRole("slider", { name: "Frame" });
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await settled(page, "frame 3 of 60");
  assert.match(await slider.getAttribute("aria-valuetext"), /found .*sx -?0\.\d+/);
  await page.keyboard.press("End");
  await settled(page, "frame 60 of 60");
  await page.locator("body").click({ position: { x: 2, y: 2 } });
  await page.keyboard.press("PageUp");
  await settled(page, "frame 30 of 60");
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("a click into a chart, the map or the table of events goes to the frame", async () => {
  const page = await openPage(flight);
  const over = page.locator("#charts .u-over").first(), box = await over.boundingBox();
  await over.click({ position: { x: box.width * 0.5, y: 40 } });
  await until(async () => Math.abs(await row(page) - 30) <= 3, "the middle of the chart is the middle of the flight");
  await until(() => page.evaluate(() => {
    const mark = document.getElementById("status-now").getBoundingClientRect(), strip = document.getElementById("status")
      .getBoundingClientRect();
    return mark.height > 0 && Math.abs((mark.left + mark.width / 2 - strip.left) / strip.width - 0.5) < 0.06;
  }), "the strip of the status has its mark there, too");
  const first = await page.locator("#picture").getAttribute("aria-label");
  await over.click({ position: { x: box.width * 0.9, y: 40 } });
  await until(async () => await page.locator("#picture").getAttribute("aria-label") !== first, "the frame changes");
  const before = await row(page), map = await page.locator("#map").boundingBox();
  await page.locator("#map").click({ position: { x: map.width * 0.05, y: map.height / 2 } });
  await until(async () => await row(page) < before, "the left end of the map is the start");
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("glare, a change of branch, a turn and a lost frame are events, and a click goes to each", async () => {
  eventful(join(at.folder, "eventful"));
  await run("report", join(at.folder, "eventful"), "--quiet");
  const page = await openPage("file://" + join(at.folder, "eventful/report.html"));
  await settled(page, "frame 1 of 300");
  assert.equal(await page.locator("#event-count").textContent(), "4 of 4");
  for (const [kind, text, first] of [["branch", "at +25.0 deg, the one before was at -20.0 deg", 150], ["glare", "flag glare", 60],
    ["dropped", "frame was dropped", 250], ["turn", "turned in place", 200]]) {
    await page.locator("#kind").selectOption(kind);
    assert.equal(await page.locator("#events tr").count(), 1, kind);
    await page.getByRole("button", { name: new RegExp(`^Go to .*${text.replace(/[+.]/g, "\\$&")}`) }).click();
    await until(async () => await row(page) === first, `the scrubber is at the ${kind}`);
    await settled(page, `frame ${first + 1} of 300`);
  }
  await page.locator("#kind").selectOption("");
  await page.locator("#events button").first().focus();
  await page.keyboard.press("Enter");
  await until(async () => await row(page) === 60, "by keyboard, too");
  await page.getByRole("button", { name: "Next event" }).click();
  await until(async () => await row(page) === 150, "the next event");
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("plays, and zooms the map", async () => {
  const page = await openPage(flight);
  await page.getByRole("button", { name: "Play" }).click();
  await until(async () => await row(page) > 5, "it plays");
  await page.getByRole("button", { name: "Pause" }).click();
  const shot = await page.locator("#map").screenshot();
  await page.getByRole("button", { name: "Zoom in" }).click();
  assert.notDeepEqual(await page.locator("#map").screenshot(), shot);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});

test("fits a narrow phone", async () => {
  for (const address of [flight, clip]) {
    const page = await openPage(address, { width: 360, height: 740 });
    await settled(page, "frame 1 of");
    assert.equal(await isWiderThanScreen(page), false);
    const picture = await page.locator("#picture").boundingBox();
    assert.ok(picture.width > 280 && picture.x >= 0 && picture.x + picture.width <= 360);
    assert.deepEqual(page.faults, []);
    await page.context().close();
  }
});

test("is open to screen readers and keyboards (axe-core)", async () => {
  for (const address of [flight, clip])
    for (const scheme of ["dark", "light"]) {
      const page = await openPage(address);
      await page.emulateMedia({ colorScheme: scheme });
      assert.deepEqual(await barriers(page), [], `${address}, ${scheme}`);
      await page.context().close();
    }
});

test("opens with an hour at 30 Hz", async t => {
  anHour(join(at.folder, "hour"));
  await run("report", join(at.folder, "hour"), "--quiet");
  const begin = Date.now();
  const page = await openPage("file://" + join(at.folder, "hour/report.html"));
  await settled(page, "frame 1 of 108000");
  const seconds = (Date.now() - begin) / 1000;
  t.diagnostic(`opened in ${seconds} s`);
  assert.ok(seconds < 20, `${seconds} s`);  // a loaded machine; docs/see.md has the figure of an idle one
  await page.getByRole("slider", { name: "Frame" }).focus();
  await page.keyboard.press("End");
  await settled(page, "frame 108000 of 108000");
  assert.match(await page.locator("#event-count").textContent(), /^12 of 12$/);
  assert.deepEqual(page.faults, []);
  await page.context().close();
});
