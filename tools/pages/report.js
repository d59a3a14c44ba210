"use strict";
// The page of `adit report`. Everything it shows stands in the script element #report. One script of five files: this,
// report_charts.js, report_status.js, report_map.js, report_scrubber.js.
const $ = id => document.getElementById(id);
const began = performance.now();
const R = JSON.parse($("report").textContent);
$("report").textContent = "";

function bytes(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text), out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) out[i] = raw.charCodeAt(i);
  return out;
}
const time = new Float64Array(bytes(R.time_s).buffer);
const columns = {}, words = {};
for (const [name, text] of Object.entries(R.columns || {})) columns[name] = new Float32Array(bytes(text).buffer);
for (const [name, w] of Object.entries(R.words || {})) words[name] = { known: w.known, codes: bytes(w.codes) };
const rows = R.rows;
const number = (name, row) => columns[name] ? columns[name][row] : NaN;
const word = (name, row) => words[name] ? words[name].known[words[name].codes[row]] : "";
const sourceRows = R.sources.map(x => x[0]);
const shown = (value, digits = 2) => Number.isFinite(value) ? value.toFixed(digits) : "–";
const dark = matchMedia("(prefers-color-scheme: dark)");
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
let at = 0;

/// The last entry of a growing list that is not above a value.
function lastAt(list, value) {
  let low = 0, high = list.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (list[middle] <= value) low = middle; else high = middle - 1;
  }
  return low;
}
/// The nearest kept picture of a row; -1 if there is none.
function nearest(kept, row) {
  if (!kept.rows.length) return -1;
  const k = lastAt(kept.rows, row);
  return k + 1 < kept.rows.length && kept.rows[k + 1] - row < row - kept.rows[k] ? k + 1 : k;
}
/// Pictures are decoded when they are wanted, the newest wish first.
function pictureOf(kept, draw) {
  let wanted = -1, busy = false, on = -1, image = null;
  async function work() {
    busy = true;
    while (wanted !== on) {
      const k = wanted;
      const blob = new Blob([bytes(kept.jpeg.slice(kept.offsets[k], kept.offsets[k + 1]))], { type: "image/jpeg" });
      const next = await createImageBitmap(blob);
      if (image) image.close();
      image = next;
      on = k;
    }
    busy = false;
    draw(image, kept.rows[on]);
  }
  return row => {
    wanted = nearest(kept, row);
    if (wanted < 0) return;
    if (wanted === on && !busy) return draw(image, kept.rows[on]);
    if (!busy) work();
  };
}

// --- the frame and its overlay
const picture = $("picture"), overlay = $("overlay");
if (R.overlay_is_drawn) { overlay.checked = true; overlay.disabled = true; overlay.title = "drawn into the film"; }
function drawFrame(image, row) {
  picture.width = image.width;
  picture.height = image.height;
  const c = picture.getContext("2d");
  c.drawImage(image, 0, 0);
  $("which").textContent = row === at ? "" : `picture of ${shown(time[row])} s, the nearest one kept`;
  if (overlay.checked && !R.overlay_is_drawn) drawOverlay(c, row, image.width / R.frame_size_px[0]);
}
function drawOverlay(c, row, scale) {
  const u = number("u_px", row) * scale, v = number("v_px", row) * scale, w = c.canvas.width, h = c.canvas.height;
  c.lineWidth = 2;
  c.strokeStyle = "#ff2828";
  if (Number.isFinite(u)) {
    c.beginPath(); c.arc(u, v, w / 24, 0, 2 * Math.PI); c.stroke();
    c.beginPath(); c.moveTo(u - 5, v); c.lineTo(u + 5, v); c.moveTo(u, v - 5); c.lineTo(u, v + 5); c.stroke();
  } else {
    const text = word("status", row) || "no answer";
    c.fillStyle = "#000a"; c.fillRect(0, 0, w, 24);
    c.fillStyle = "#ffb4ab"; c.font = "15px system-ui, sans-serif"; c.fillText(text, 8, 17);
  }
  const rate = number("yaw_rate_rad_s", row);
  if (Number.isFinite(rate) && Math.abs(rate) > 1e-3) {  // positive is to the left; half the width is 1 rad/s
    const x = w / 2 - Math.max(-1, Math.min(1, rate)) * w / 2, y = h - 12, d = Math.sign(x - w / 2) * 7;
    c.strokeStyle = "#35ff7a"; c.lineWidth = 3;
    c.beginPath(); c.moveTo(w / 2, y); c.lineTo(x, y); c.moveTo(x - d, y - 6); c.lineTo(x, y); c.lineTo(x - d, y + 6);
    c.stroke();
  }
}
const showFrame = pictureOf(R.frames, drawFrame);
if (!R.frames.rows.length) { picture.hidden = true; $("no-picture").hidden = false; overlay.disabled = true; }
overlay.addEventListener("change", () => showFrame(at));

// --- the stages
const tiles = R.tiles.names.map(name => {
  const figure = document.createElement("figure"), canvas = document.createElement("canvas");
  const caption = document.createElement("figcaption");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", "Stage: " + name);
  caption.textContent = name;
  figure.append(canvas, caption);
  $("stages").append(figure);
  return canvas;
});
const showStages = pictureOf(R.stages, (image, row) => {
  const across = R.tiles.columns, down = Math.ceil(tiles.length / across);
  const w = image.width / across, h = image.height / down;
  tiles.forEach((canvas, i) => {
    canvas.width = w; canvas.height = h;
    canvas.getContext("2d").drawImage(image, i % across * w, Math.floor(i / across) * h, w, h, 0, 0, w, h);
  });
  $("stages-which").textContent = row === at ? "" : `of the frame at ${shown(time[row])} s, the nearest one kept`;
});
if (!R.stages.rows.length) $("stages-section").hidden = true;

// --- what the row says
function sayRow(row) {
  const status = word("status", row), parts = [];
  parts.push(word("delivery", row) === "dropped" ? "frame dropped" : status || "no frame");
  if (status === "found") {
    parts.push(`confidence ${shown(number("confidence", row))}`, `sx ${shown(number("sx", row), 3)}`,
      `sy ${shown(number("sy", row), 3)}`, `azimuth ${shown(number("azimuth_deg", row), 1)}°`);
  }
  const rate = number("yaw_rate_rad_s", row);
  if (Number.isFinite(rate)) parts.push(`${word("heading_state", row)}, yaw ${shown(rate)} rad/s`);
  if (word("flags", row)) parts.push(word("flags", row));
  if (R.flight && Number.isFinite(number("side_clearance_m", row)))
    parts.push(`side clearance ${shown(number("side_clearance_m", row))} m`);
  if (R.sources.length) {
    const s = lastAt(sourceRows, row);
    parts.push(R.sources[s][1].split("/").pop());
  }
  return parts.join(" · ");
}
