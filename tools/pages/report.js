"use strict";
// The page of `adit report`. Everything it shows stands in the script element #report.
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

// --- charts
const plots = [], series = (label, name, stroke, extra = {}) => ({ label, name, stroke, ...extra });
const groups = [
  ["sx and sy: right and down of the axis", [series("sx", "sx", "#35a4ff"), series("sy", "sy", "#ff9f40")]],
  ["Azimuth, degrees, positive to the right", [series("answer", "azimuth_deg", "#35a4ff"),
    series("passage 5 m ahead", "passage_azimuth_deg", "#9aa2ad", { dash: [6, 4] })]],
  ["Confidence", [series("confidence", "confidence", "#2fb457"), series("veil", "veil_fraction", "#c79bff")], [0, 1]],
  ["Yaw rate, rad/s, positive to the left", [series("yaw rate", "yaw_rate_rad_s", "#2fb457")]],
  ["Speed, share of what is set", [series("speed", "speed_scale", "#c79bff")], [0, 1]],
  ["Side clearance, m", [series("side clearance", "side_clearance_m", "#ff6b81")]],
];
function makeCharts() {
  for (const plot of plots.splice(0)) plot.destroy();
  $("charts").textContent = "";
  const sync = uPlot.sync("time"), width = $("charts").clientWidth;
  for (const [title, all, range] of groups) {
    const there = all.filter(s => columns[s.name] && columns[s.name].some(Number.isFinite));
    if (!there.length) continue;
    const box = document.createElement("div"), head = document.createElement("p"), chart = document.createElement("div");
    head.textContent = title;
    head.className = "faint";
    chart.setAttribute("role", "img");
    chart.setAttribute("aria-label", "Chart: " + title);
    box.append(head, chart);
    $("charts").append(box);
    const axis = { stroke: colour("--faint"), grid: { stroke: colour("--line"), width: 1 }, ticks: { stroke: colour("--line") } };
    const plot = new uPlot({
      width, height: 150, legend: { live: true },
      scales: { x: { time: false }, y: range ? { range } : { range: spread } },
      cursor: { sync: { key: sync.key, setSeries: false }, drag: { x: true, y: false } },
      axes: [{ ...axis, values: (u, ticks) => ticks.map(t => t + " s") }, { ...axis, size: 56 }],
      series: [{ label: "time", value: (u, v) => v == null ? "" : v.toFixed(2) + " s" },
        ...there.map(s => ({ label: s.label, stroke: s.stroke, width: 1.25, dash: s.dash, spanGaps: false,
          points: { show: false }, value: (u, v) => shown(v, 3) }))],
      hooks: { ready: [u => {
        u.now = document.createElement("div");
        u.now.className = "now";
        u.over.append(u.now);
        drawNow(u);
      }], setScale: [u => { if (u.now) drawNow(u); }] },
    }, [time, ...there.map(s => columns[s.name])], chart);
    plot.over.addEventListener("click", () => {
      // A drag ends in a click too; it has a selection.
      if (plot.cursor.idx != null && !plot.dragged) go(plot.cursor.idx);
    });
    plot.over.addEventListener("mousedown", e => { plot.downAt = e.clientX; plot.dragged = false; });
    plot.over.addEventListener("mouseup", e => { plot.dragged = Math.abs(e.clientX - plot.downAt) > 3; });
    plots.push(plot);
  }
}
function spread(u, low, high) {
  if (low == null) return [-1, 1];
  const room = Math.max(0.05 * (high - low), 0.02);
  return [low - room, high + room];
}
/// The line at the frame on show lies over the plot: an hour of rows is not drawn again for it.
function drawNow(u) {
  const x = u.valToPos(time[at], "x");
  u.now.style.left = x + "px";
  u.now.hidden = !(x >= 0 && x <= u.over.clientWidth);
}

// --- status over time
const statusColours = { found: "#2fb457", "": "#6b7280", no_opening: "#e5484d", dust: "#c79b3b", too_dark: "#7c4dff",
  too_bright: "#ffd23f", no_contrast: "#b08968", blocked_lens: "#ff8ef3", unreadable: "#111111" };
const statusColour = name => statusColours[name] || "#ff9f40";
function drawStatus() {
  const canvas = $("status"), c = canvas.getContext("2d"), w = canvas.width = canvas.clientWidth || 300;
  canvas.height = 14;
  const codes = words.status.codes, known = words.status.known, end = time[rows - 1] || 1;
  const worst = new Int16Array(w).fill(-1);  // a refusal of one frame must not vanish between pixels
  for (let row = 0; row < rows; ++row) {
    const x = Math.min(w - 1, Math.floor(time[row] / end * w));
    if (worst[x] < 0 || known[worst[x]] === "found") worst[x] = codes[row];
  }
  for (let x = 0, last = 0; x < w; ++x) {
    if (worst[x] >= 0) last = worst[x];
    c.fillStyle = statusColour(known[last]);
    c.fillRect(x, 0, 1, 14);
  }
  $("status-keys").replaceChildren(...known.filter((name, i) => codes.includes(i)).map(name => {
    const key = document.createElement("span"), mark = document.createElement("i");
    mark.style.background = statusColour(name);
    key.append(mark, name || "no frame");
    return key;
  }));
}
$("status").addEventListener("click", e => {
  go(lastAt(time, e.offsetX / $("status").clientWidth * time[rows - 1]));
});

// --- the map
const map = $("map");
let ground = null, view = null;
function wholeView() {
  let x0 = Infinity, x1 = -Infinity, y0 = Infinity, y1 = -Infinity;
  for (let i = 0; i < rows; ++i) {
    const x = columns.x_m[i], y = columns.y_m[i];
    x0 = Math.min(x0, x); x1 = Math.max(x1, x); y0 = Math.min(y0, y); y1 = Math.max(y1, y);
  }
  const span = Math.max((x1 - x0) / map.clientWidth, (y1 - y0) / map.clientHeight) * 1.1 + 8 / map.clientHeight;
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, m_px: span };
}
function arrow(c, x, y, angle, length, stroke, width) {
  const tx = x + length * Math.cos(angle), ty = y - length * Math.sin(angle);
  c.strokeStyle = c.fillStyle = stroke;
  c.lineWidth = width;
  c.beginPath(); c.moveTo(x, y); c.lineTo(tx, ty); c.stroke();
  c.beginPath(); c.moveTo(tx, ty);
  for (const side of [-2.6, 2.6]) c.lineTo(tx + 9 * Math.cos(angle + side), ty - 9 * Math.sin(angle + side));
  c.fill();
}
/// The ground and the way: drawn again only when the view is another.
const still = document.createElement("canvas");
let stillOf = "";
function drawStill(w, h, ratio, X, Y) {
  const key = [w, h, ratio, view.x, view.y, view.m_px, Boolean(ground)].join();
  if (key === stillOf) return;
  stillOf = key;
  still.width = w * ratio; still.height = h * ratio;
  const c = still.getContext("2d");
  c.scale(ratio, ratio);
  c.fillStyle = "#cdcdcd"; c.fillRect(0, 0, w, h);
  if (ground) {
    c.imageSmoothingEnabled = false;
    const m = R.map, gw = ground.width * m.cell_m, gh = ground.height * m.cell_m;
    c.drawImage(ground, X(m.x_min_m), Y(m.y_min_m + gh), gw / view.m_px, gh / view.m_px);
  }
  c.strokeStyle = "#6c8ebf"; c.lineWidth = 1.5; c.beginPath();
  let px = NaN, py = NaN, lx = NaN, ly = NaN;
  const due = [];
  for (let i = 0; i < rows; ++i) {
    const x = X(columns.x_m[i]), y = Y(columns.y_m[i]);
    if (Math.hypot(x - lx, y - ly) < 1) continue;  // less than a pixel on
    i ? c.lineTo(x, y) : c.moveTo(x, y);
    lx = x; ly = y;
    if (!(Math.hypot(x - px, y - py) < 34)) { due.push(i); px = x; py = y; }  // an arrow every 34 px
  }
  c.stroke();
  for (const i of due) poseArrow(c, i, X, Y, 14, 1.25);
  // A bar of a round length.
  const round = [0.5, 1, 2, 5, 10, 20, 50, 100, 200].find(m => m / view.m_px > 60) || 500;
  c.fillStyle = "#000"; c.fillRect(12, h - 16, round / view.m_px, 3);
  c.font = "12px system-ui, sans-serif"; c.fillText(round + " m", 12, h - 21);
}
function poseArrow(c, i, X, Y, long, width) {
  const yaw = columns.yaw_deg[i] * Math.PI / 180, azimuth = columns.azimuth_deg[i] * Math.PI / 180;
  const x = X(columns.x_m[i]), y = Y(columns.y_m[i]);
  if (Number.isFinite(azimuth)) arrow(c, x, y, yaw - azimuth, long * 1.5, "#2fb457", width);
  arrow(c, x, y, yaw, long, "#e5484d", width);
}
function drawMap() {
  if (!columns.x_m) return;
  const ratio = devicePixelRatio || 1, w = map.clientWidth, h = map.clientHeight, c = map.getContext("2d");
  if (!view) view = wholeView();
  if ($("map-follow").checked) { view.x = columns.x_m[at]; view.y = columns.y_m[at]; }
  const X = x => w / 2 + (x - view.x) / view.m_px, Y = y => h / 2 - (y - view.y) / view.m_px;
  drawStill(w, h, ratio, X, Y);
  map.width = w * ratio; map.height = h * ratio;
  c.drawImage(still, 0, 0);
  c.scale(ratio, ratio);
  c.fillStyle = "#0006";
  c.beginPath(); c.arc(X(columns.x_m[at]), Y(columns.y_m[at]), 9, 0, 7); c.fill();
  poseArrow(c, at, X, Y, 34, 3.5);
  map.setAttribute("aria-label", `Map seen from above: x ${shown(columns.x_m[at], 1)} m, y ${shown(columns.y_m[at], 1)} m, `
    + `yaw ${shown(columns.yaw_deg[at], 0)} degrees`);
}
function zoom(factor) { view.m_px = Math.min(5, Math.max(0.002, view.m_px * factor)); drawMap(); }
function setUpMap() {
  if (!columns.x_m) { $("map-section").hidden = true; return; }
  let down = null;
  map.addEventListener("pointerdown", e => { down = { x: e.clientX, y: e.clientY, vx: view.x, vy: view.y, moved: false };
    map.setPointerCapture(e.pointerId); });
  map.addEventListener("pointermove", e => {
    if (!down) return;
    const dx = e.clientX - down.x, dy = e.clientY - down.y;
    if (Math.hypot(dx, dy) > 3) { down.moved = true; $("map-follow").checked = false; }
    if (down.moved) { view.x = down.vx - dx * view.m_px; view.y = down.vy + dy * view.m_px; drawMap(); }
  });
  map.addEventListener("pointerup", e => {
    if (down && !down.moved) {
      const box = map.getBoundingClientRect();
      const x = view.x + (e.clientX - box.left - box.width / 2) * view.m_px;
      const y = view.y - (e.clientY - box.top - box.height / 2) * view.m_px;
      let best = 0, least = Infinity;
      for (let i = 0; i < rows; ++i) {
        const d = (columns.x_m[i] - x) ** 2 + (columns.y_m[i] - y) ** 2;
        if (d < least) { least = d; best = i; }
      }
      go(best);
    }
    down = null;
  });
  map.addEventListener("wheel", e => { e.preventDefault(); zoom(e.deltaY > 0 ? 1.2 : 1 / 1.2); }, { passive: false });
  map.addEventListener("keydown", e => {
    const step = 40 * view.m_px;
    const move = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[e.key];
    if (move) { view.x += move[0]; view.y += move[1]; $("map-follow").checked = false; drawMap(); }
    else if (e.key === "+") zoom(1 / 1.2); else if (e.key === "-") zoom(1.2); else return;
    e.preventDefault();
  });
  $("map-in").onclick = () => zoom(1 / 1.4);
  $("map-out").onclick = () => zoom(1.4);
  $("map-all").onclick = () => { view = wholeView(); $("map-follow").checked = false; drawMap(); };
  $("map-follow").onchange = drawMap;
  if (R.map) createImageBitmap(new Blob([bytes(R.map.png)], { type: "image/png" })).then(image => { ground = image; drawMap(); });
  drawMap();
}

// --- events
const events = R.events.map(([first, last, kind, text]) => ({ first, last, kind, text }));
function listEvents() {
  const kind = $("kind").value, list = kind ? events.filter(e => e.kind === kind) : events;
  $("event-count").textContent = `${list.length} of ${events.length}`
    + (R.events_left_out ? `; ${R.events_left_out} more are left out` : "");
  $("events").replaceChildren(...list.map(e => {
    const tr = document.createElement("tr"), when = document.createElement("button");
    when.textContent = shown(time[e.first]) + " s";
    when.setAttribute("aria-label", `Go to ${shown(time[e.first])} s: ${e.text}`);
    when.onclick = () => go(e.first);
    const cells = [when, shown(time[e.last] - time[e.first]) + " s", e.kind, e.text].map(content => {
      const td = document.createElement("td");
      td.append(content);
      return td;
    });
    tr.append(...cells);
    return tr;
  }));
}
for (const kind of new Set(events.map(e => e.kind))) $("kind").append(new Option(kind, kind));
$("kind").onchange = listEvents;
$("next").onclick = () => { const e = events.find(x => x.first > at); if (e) go(e.first); };
$("back").onclick = () => { const e = events.findLast(x => x.first < at); if (e) go(e.first); };
if (!events.length) $("next").disabled = $("back").disabled = true;

// --- the scrubber
const slider = $("row");
slider.max = rows - 1;
let drawing = false;
function go(row) {
  at = Math.max(0, Math.min(rows - 1, row));
  slider.value = at;
  if (drawing) return;
  drawing = true;
  requestAnimationFrame(() => {
    drawing = false;
    const text = sayRow(at);
    $("says").textContent = text;
    $("at").textContent = `${shown(time[at])} of ${shown(time[rows - 1])} s, frame ${at + 1} of ${rows}`;
    slider.setAttribute("aria-valuetext", `${shown(time[at])} s, ${text}`);
    picture.setAttribute("aria-label", `Frame at ${shown(time[at])} s: ${text}`);
    showFrame(at);
    showStages(at);
    drawMap();
    for (const plot of plots) { drawNow(plot); plot.setLegend({ idx: at }); }
  });
}
slider.addEventListener("input", () => go(Number(slider.value)));
let playing = 0;
$("play").onclick = () => {
  const begin = !playing;
  $("play").textContent = begin ? "Pause" : "Play";
  $("play").setAttribute("aria-pressed", String(begin));
  if (!begin) { cancelAnimationFrame(playing); playing = 0; return; }
  if (at === rows - 1) go(0);
  let from = time[at], since = performance.now(), set = at;
  const step = now => {
    if (set !== at) { from = time[at]; since = now; }  // somebody scrubbed
    go(lastAt(time, from + (now - since) / 1000));
    set = at;
    if (at >= rows - 1) return $("play").onclick();
    playing = requestAnimationFrame(step);
  };
  playing = requestAnimationFrame(step);
};
document.addEventListener("keydown", e => {
  if (/INPUT|SELECT|BUTTON|SUMMARY/.test(e.target.tagName) || e.target === map || e.ctrlKey || e.metaKey || e.altKey) return;
  const step = { ArrowLeft: -1, ArrowRight: 1, PageUp: -30, PageDown: 30 }[e.key];
  if (step) go(at + step); else if (e.key === "n") $("next").click(); else if (e.key === "p") $("back").click();
  else if (e.key === " ") $("play").click(); else return;
  e.preventDefault();
});

// --- the rest
for (const [name, value] of R.figures) {
  const dt = document.createElement("dt"), dd = document.createElement("dd");
  dt.textContent = name;
  dd.textContent = value;
  $("figures").append(dt, dd);
}
const list = (id, texts) => $(id).append(...texts.map(text => {
  const li = document.createElement("li");
  li.textContent = text;
  return li;
}));
if (R.notes.length) { $("notes").hidden = false; list("notes", R.notes); }
$("command").textContent = R.origin.command;
$("made").textContent = R.origin.version ? `adit ${R.origin.version}` : "By which version and with which settings is not known: the folder does not say.";
list("changed", R.origin.changed);
if (!R.origin.changed.length) $("changed-head").textContent = R.origin.settings ? "All settings are the defaults." : "";
$("settings").textContent = R.origin.settings;
if (!R.origin.settings) $("settings-part").hidden = true;

function layOut() { makeCharts(); drawStatus(); drawMap(); }
makeCharts();
drawStatus();
setUpMap();
listEvents();
go(0);
let width = innerWidth;
addEventListener("resize", () => { if (innerWidth !== width) { width = innerWidth; layOut(); } });
dark.addEventListener("change", layOut);
document.documentElement.dataset.readyMs = String(Math.round(performance.now() - began));
