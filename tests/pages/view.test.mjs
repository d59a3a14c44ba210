// The page of `adit view` and `adit fly --view`, as a person meets it.
import { after, before, test } from "node:test";
import assert from "node:assert/strict";
import http from "node:http";
import net from "node:net";
import { copyFileSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { barriers, closeBrowser, drawnShare, isWiderThanScreen, openBrowser, openPage, program, run, scratch, serve, source,
  until } from "./browser.mjs";

const clip = join(source, "data/clip.avi");

/// One request with headers of our own; the status, headers and text.
function ask(address, path, { headers = {}, method = "GET", body = "" } = {}) {
  const url = new URL(address);
  return new Promise((resolve, reject) => {
    const request = http.request({ host: "127.0.0.1", port: url.port, path, method, headers: { Host: url.host, ...headers } },
      response => {
        let text = "";
        response.on("data", d => { text += d; });
        response.on("end", () => resolve({ status: response.statusCode, headers: response.headers, text }));
      });
    request.on("error", reject);
    request.end(body);
  });
}
const state = async (address, after = 1e9) => JSON.parse((await ask(address, "/state?after=" + after)).text);
const framesIn = async (address, seconds) => {
  const before = (await state(address)).frames;
  await new Promise(r => setTimeout(r, 1000 * seconds));
  return (await state(address)).frames - before;
};

before(openBrowser);
after(closeBrowser);

test("shows what is seen, live, and ends clean while somebody looks on", async () => {
  const view = await serve("view", clip, "--loop");
  assert.match(view.address, /^http:\/\/127\.0\.0\.1:\d+\/$/);
  const page = await openPage(view.address);
  await until(() => page.evaluate(() => document.getElementById("stream").naturalWidth > 0), "a picture comes");
  await until(async () => await page.locator("#status").textContent() === "found", "the gauges move");
  const count = async () => Number((await page.locator("#foot").textContent()).match(/(\d+) frames/)[1]);
  const before = await count();
  await until(async () => await count() > before + 10, "frames go on");
  await until(async () => await drawnShare(page, "#chart-s canvas") > 0.005, "the timeline is drawn");
  await page.locator("#which").selectOption("depth");
  await until(async () => {
    const box = await page.locator("#stream").boundingBox();
    return box.width > 2 * box.height;
  }, "the depth map comes beside it");
  assert.deepEqual(page.faults, []);
  assert.deepEqual(page.asked.filter(url => !url.startsWith(view.address) && !/^(data|blob):/.test(url)), []);
  const end = await view.end();
  assert.equal(end.code, 0);
  assert.ok(end.seconds < 8, `${end.seconds} s`);
  assert.match(view.said(), /\d+ frames were shown/);
  await until(async () => /has ended/.test(await page.locator("#line").textContent()), "the page says so");
  await page.context().close();
});

test("settings hold from the next frame on and are saved as YAML", async () => {
  const view = await serve("view", clip, "--loop");
  const page = await openPage(view.address);
  await page.getByLabel("cluster_count").fill("5");
  await page.keyboard.press("Tab");
  await until(async () => /cluster_count is 5/.test(await page.locator("#said").textContent()), "it is taken");
  assert.match((await ask(view.address, "/settings.yaml")).text, /^  cluster_count: 5$/m);
  await page.getByLabel("omega").fill("7");
  await page.keyboard.press("Tab");
  await until(async () => /omega.*7/.test(await page.locator("#said").textContent()), "it is refused, and why");
  assert.equal(await page.getByLabel("omega").inputValue(), "0.95");
  await page.locator("[id='finder.method']").selectOption("adit");
  await until(async () => /method is adit/.test(await page.locator("#said").textContent()), "the method changes");
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("link", { name: "Save as YAML" }).click()]);
  assert.equal(download.suggestedFilename(), "adit.yaml");
  // A browser tells of the refusal itself; it is no fault of the page.
  assert.deepEqual(page.faults.filter(text => !/400/.test(text)), []);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
});

/// What the picture shows now, to be compared with later.
const pictureOf = page => page.evaluate(() => {
  const canvas = document.createElement("canvas"), image = document.getElementById("stream");
  canvas.width = image.naturalWidth || 1; canvas.height = image.naturalHeight || 1;
  canvas.getContext("2d").drawImage(image, 0, 0);
  return canvas.toDataURL("image/png");
});
async function untilPictureMoves(page, what) {
  const before = await pictureOf(page);
  await until(async () => await pictureOf(page) !== before, what);
}
const isOld = async page => await page.locator("#since").isVisible() && await page.locator("#now.old").count() === 1;

test("picture and gauges come back after adit was started again, and what is old does not look like now", async () => {
  const first = await serve("view", clip, "--loop");
  const page = await openPage(first.address);
  await until(async () => /^[1-9]\d\d/.test((await page.locator("#foot").textContent()).replace(/.*, /, "")), "100 frames", 60);
  assert.equal(await isOld(page), false);
  assert.equal((await first.end()).code, 0);
  await until(() => isOld(page), "the gauges are old");
  assert.match(await page.locator("#since").textContent(), /^no answer since \d+ s$/);
  const second = await serve("view", clip, "--loop", "--port", new URL(first.address).port);
  assert.equal(second.address, first.address);
  await until(async () => !await isOld(page), "rows come, though their numbers began again", 10);
  await untilPictureMoves(page, "the picture goes on");
  await page.getByLabel("cluster_count").fill("5");
  await page.keyboard.press("Tab");
  await until(async () => /cluster_count is 5/.test(await page.locator("#said").textContent()), "its settings can be changed");
  assert.deepEqual(page.faults.filter(text => !/Failed to load resource/.test(text)), []);
  await page.context().close();
  assert.equal((await second.end()).code, 0);
});

test("a stream that broke is asked for anew", async () => {
  const view = await serve("view", clip, "--loop");
  const page = await openPage(view.address);
  await untilPictureMoves(page, "a picture comes");
  await page.context().setOffline(true);
  await until(() => isOld(page), "the gauges are old");
  await page.context().setOffline(false);
  await until(async () => !await isOld(page), "rows come");
  await untilPictureMoves(page, "the picture goes on");
  assert.deepEqual(page.faults.filter(text => !/Failed to load resource/.test(text)), []);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
});

test("a source that stands still is told, and a setting changed elsewhere is shown here", async () => {
  const view = await serve("view", clip);
  const page = await openPage(view.address), other = await openPage(view.address);
  for (const one of [page, other]) await until(async () => await one.locator(".field").count() > 10, "the settings come");
  await other.getByLabel("cluster_count").fill("6");
  await other.keyboard.press("Tab");
  await until(async () => await page.getByLabel("cluster_count").inputValue() === "6", "the other page's setting is here");
  await until(() => isOld(page), "the clip has ended: the gauges are old", 60);
  assert.deepEqual(page.faults, []);
  for (const one of [page, other]) await one.context().close();
  await view.end();
});

test("a camera that sends the same frame for ever is told, as adit run tells it", async () => {
  const at = scratch();
  for (let i = 0; i < 12; ++i) copyFileSync(join(source, "data/tunnel.jpg"), join(at.folder, `${i + 10}.jpg`));
  const view = await serve("view", at.folder, "--method", "adit", "--fps", "10", "--loop");
  const page = await openPage(view.address);
  await until(async () => await page.locator("#status").textContent() === "frozen_frame", "it is frozen");
  assert.match(await run("run", at.folder, "--sequence", "--method", "adit", "--csv", "-", "--quiet"), /,frozen_frame,/);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
  at.remove();
});

test("fits a narrow phone and is open to screen readers and keyboards (axe-core)", async () => {
  const view = await serve("view", clip, "--loop");
  const page = await openPage(view.address, { width: 360, height: 740 });
  await until(async () => await page.locator("#status").textContent() === "found", "the gauges move");
  await until(async () => await page.locator(".field").count() > 10, "the settings come");
  assert.equal(await isWiderThanScreen(page), false);
  for (const scheme of ["dark", "light"]) {
    await page.emulateMedia({ colorScheme: scheme });
    assert.deepEqual(await barriers(page), [], scheme);
  }
  await page.getByRole("button", { name: "Pause" }).focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.getByRole("button", { name: "Go on" }).getAttribute("aria-pressed"), "true");
  assert.deepEqual(page.faults, []);
  await page.context().close();
  await view.end();
});

// The driver's part is played by a library that is preloaded.
test("a camera is seen live, and when it is unplugged that is told", async () => {
  const driver = { LD_PRELOAD: join(dirname(program), "tests/camera/adit_v4l2_stand_in.so"), ADIT_STAND_IN_UNPLUG_AFTER: "600" };
  Object.assign(process.env, driver);
  const view = await serve("view", "/dev/video0", "--method", "paper");
  for (const name of Object.keys(driver)) delete process.env[name];
  const page = await openPage(view.address);
  await until(() => page.evaluate(() => document.getElementById("stream").naturalWidth === 640), "a picture comes");
  await until(async () => await page.locator("#status").textContent() === "found", "the gauges move");
  await until(async () => /has ended/.test(await page.locator("#line").textContent()), "the page says so", 60);
  assert.ok((await state(view.address)).frames > 100);
  assert.deepEqual(page.faults, []);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
  assert.match(view.said(), /\/dev\/video0: the camera gave no more frames; unplugged\?/);
});

test("slow viewers never slow the perception", async t => {
  const view = await serve("view", clip, "--loop");
  const port = new URL(view.address).port;
  const alone = await framesIn(view.address, 3);
  // They ask for the stream and never read a byte of it.
  const slow = Array.from({ length: 8 }, () => {
    const socket = net.connect({ port, host: "127.0.0.1" });
    socket.on("error", () => {});
    socket.pause();
    socket.write(`GET /stream.mjpg HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\n\r\n`);
    return socket;
  });
  await framesIn(view.address, 4);  // their buffers fill
  const crowded = await framesIn(view.address, 3);
  t.diagnostic(`${alone} frames in 3 s alone, ${crowded} with 8 viewers that do not read`);
  assert.ok(crowded >= 0.75 * alone, `${crowded} of ${alone}`);
  const end = await view.end();
  assert.equal(end.code, 0);
  assert.ok(end.seconds < 10, `${end.seconds} s`);
  for (const socket of slow) socket.destroy();
});

test("many may look on, and one too many is told", async () => {
  const view = await serve("view", clip, "--loop");
  const port = new URL(view.address).port;
  const first = () => new Promise(resolve => {
    const socket = net.connect({ port, host: "127.0.0.1" }, () =>
      socket.write(`GET /stream.mjpg HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\n\r\n`));
    socket.on("error", () => {});
    socket.once("data", data => resolve({ socket, line: data.toString("latin1").split("\r\n")[0] }));
  });
  const viewers = [];
  for (let i = 0; i < 24; ++i) viewers.push(await first());
  for (const viewer of viewers) assert.match(viewer.line, / 200 /);
  const more = await first();
  assert.match(more.line, / 503 /);
  assert.equal((await ask(view.address, "/state")).status, 200);
  for (const viewer of [...viewers, more]) viewer.socket.destroy();
  assert.equal((await view.end()).code, 0);
});

test("answers to its own name alone", async () => {
  const view = await serve("view", clip, "--loop");
  const host = new URL(view.address).host, port = new URL(view.address).port;
  for (const headers of [{ Host: "example.org" }, { Host: `example.org:${port}` }, { Origin: "http://example.org" }, { Origin: "null" }])
    for (const path of ["/", "/state", "/settings", "/settings.yaml", "/stream.mjpg"])
      assert.equal((await ask(view.address, path, { headers })).status, 403, path + JSON.stringify(headers));
  const post = headers => ask(view.address, "/settings", { method: "POST", body: '{"finder.omega":"0.9"}', headers });
  assert.equal((await post({ Origin: "http://example.org" })).status, 403);
  assert.equal((await post({ Origin: `http://${host}` })).status, 200);
  assert.equal((await ask(view.address, "/settings", { method: "POST", body: "[]" })).status, 400);
  assert.equal((await ask(view.address, "/none")).status, 404);
  await view.end();
});

test("on another address it wants its token", async () => {
  const view = await serve("view", clip, "--loop", "--listen", "0.0.0.0");
  const token = new URL(view.address).searchParams.get("token");
  assert.match(token, /^[0-9a-f]{32}$/);
  const wrong = (token[0] === "0" ? "1" : "0") + token.slice(1);
  for (const path of ["/", "/state", "/settings", "/stream.mjpg", `/?token=${wrong}`, "/?token=", `/state?token=${token.slice(1)}`])
    assert.equal((await ask(view.address, path)).status, 401, path);
  assert.equal((await ask(view.address, "/state", { headers: { Cookie: `adit_view=${wrong}` } })).status, 401);
  assert.equal((await ask(view.address, "/settings", { method: "POST", body: '{"finder.omega":"0.9"}' })).status, 401);
  const page = await openPage(view.address.replace("0.0.0.0", "127.0.0.1"));
  await until(async () => await page.locator("#status").textContent() === "found", "with the token it is there");
  assert.deepEqual(page.faults, []);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
});

test("a flight is seen while it is flown, from above too", async () => {
  // Long enough that the page is there before the flight is over: who comes later is shown no settings.
  const view = await serve("fly", "s_bend", "--time", "8", "--view", "--quiet");
  const page = await openPage(view.address);
  await until(async () => await page.locator("#plan-section").isVisible(), "the plan is there", 60);
  await until(() => page.getByLabel("cluster_count").isVisible(), "so are the settings");
  await until(async () => await drawnShare(page, "#plan") > 0.01, "the world is drawn");
  await until(() => page.evaluate(() => document.getElementById("stream").naturalWidth > 0), "a picture comes");
  await until(async () => /s_bend.*timeout/.test(await page.locator("#line").textContent()), "it says how it ended", 120);
  await until(() => page.getByLabel("cluster_count").isDisabled(), "what is over is not to be changed");
  assert.deepEqual(page.faults, []);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
});

test("settings changed in flight hold from the next frame on, and the flight says that it cannot be repeated", async () => {
  const at = scratch(), folder = join(at.folder, "bend"), whole = join(at.folder, "page.html");
  const small = ["--set", "lens.width=160", "--set", "lens.height=120"];
  const view = await serve("fly", "s_bend", "--time", "20", "--method", "paper", ...small, "--view", "--out", folder,
    "--report", whole);
  const page = await openPage(view.address);
  await until(async () => (await state(view.address)).frames > 0, "it flies", 60);
  await page.locator("[id='finder.method']").selectOption("adit");
  await until(async () => /method is adit/.test(await page.locator("#said").textContent()), "it is taken");
  assert.match((await ask(view.address, "/settings.yaml")).text, /^  method: adit$/m);
  await until(async () => /finder.method paper → adit/.test(await page.locator("#line").textContent()), "the page says so");
  await until(async () => /s_bend.*(timeout|goal|touched|collided)/.test(await page.locator("#line").textContent()), "it ends", 120);
  assert.match(await page.locator("#line").textContent(), /does not fly it again.*finder\.method paper → adit/);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
  const summary = JSON.parse(readFileSync(join(folder, "summary.json"), "utf8"));
  assert.equal(summary.reproducible, false);
  const [change] = summary.settings_changed_in_flight;
  assert.deepEqual([change.setting, change.from, change.to], ["finder.method", "paper", "adit"]);
  // The published controller knows no share of speed below 1; the navigator begins from rest.
  const [head, ...rows] = readFileSync(join(folder, "flight.csv"), "utf8").trim().split("\n").map(line => line.split(","));
  const shareAt = head.indexOf("speed_scale"), stampAt = head.indexOf("stamp_s");
  const before = rows.filter(row => Number(row[stampAt]) < change.stamp_s - 1e-3);
  assert.ok(before.length > 0 && before.every(row => Number(row[shareAt]) === 1));
  assert.ok(rows.slice(before.length, before.length + 10).some(row => Number(row[shareAt]) < 1));
  await run("report", folder, "--quiet");
  for (const file of [whole, join(folder, "report.html")]) {
    const report = await openPage("file://" + file);
    assert.match(await report.locator("#notes").textContent(), /does not fly it again/);
    assert.match(await report.locator("#events").textContent(), /setting.*finder\.method paper → adit/);
    assert.deepEqual(report.faults, []);
    await report.context().close();
  }
  at.remove();
});

test("a flight in a folder is played again, with its map", async () => {
  const at = scratch(), folder = join(at.folder, "bend");
  await run("fly", "s_bend", "--time", "1", "--quiet", "--video", "--out", folder);
  const view = await serve("view", folder, "--loop");
  const page = await openPage(view.address);
  await until(async () => await page.locator("#status").textContent() === "found", "the gauges move");
  await until(() => page.evaluate(() => document.getElementById("stream").naturalWidth > 0), "a picture comes");
  await until(async () => await drawnShare(page, "#plan") > 0.01, "the map is drawn");
  await until(async () => await page.locator("#speed").textContent() === "100 %", "the share of speed is shown");
  assert.equal(await page.locator("#settings-section").isVisible(), false);
  // At the end it begins again: no line runs from the end back to the start.
  let again = false, before = 0;
  await until(async () => {
    const { steps, stamp } = await page.evaluate(() => ({ stamp: rows.at(-1)?.time ?? 0,
      steps: way.slice(1).map(([x, y], i) => Math.hypot(x - way[i][0], y - way[i][1])) }));
    assert.ok(Math.max(0, ...steps) < 0.5, `a step of ${Math.max(0, ...steps)} m`);
    again ||= stamp < before;
    before = stamp;
    return again && stamp > 0.5;
  }, "it begins again");
  assert.deepEqual(page.faults, []);
  await page.context().close();
  assert.equal((await view.end()).code, 0);
  at.remove();
});
