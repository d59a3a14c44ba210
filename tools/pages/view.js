"use strict";
// The page of `adit view`: a stream of pictures, and the rows that came since the last look, five times a second.
const $ = id => document.getElementById(id);
const look_ms = 200, span_s = 60;
const patience_ms = 2000;  // without a new frame, what is on show is called old; as long as the server waits for a viewer
const shown = (value, digits = 2) => Number.isFinite(value) ? value.toFixed(digits) : "–";
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
let last = 0, paused = false, rows = [], state = null, began = null, settingsSeen = null;
let freshAt = performance.now(), streamAt = 0, streamNumber = 0;

// --- the picture; a page that nobody sees takes no stream
function stream() {
  const off = paused || document.hidden;
  if (off) return $("stream").removeAttribute("src");
  streamAt = performance.now();
  streamNumber = Math.floor(Math.random() * 2 ** 50);  // by it the server knows which stream is whose
  $("stream").src = "stream.mjpg?picture=" + $("which").value + "&stream=" + streamNumber;
}
/// A stream that the server has given up, or that broke, is asked for anew: the browser tells nobody that it ended.
function mendStream(streaming) {
  if (!streaming && !paused && !document.hidden && performance.now() - streamAt > patience_ms) stream();
}
$("which").onchange = stream;
$("pause").onclick = () => {
  paused = !paused;
  $("pause").textContent = paused ? "Go on" : "Pause";
  $("pause").setAttribute("aria-pressed", String(paused));
  if (!paused) return stream();
  // What is on show stays on show.
  const canvas = document.createElement("canvas"), image = $("stream");
  canvas.width = image.naturalWidth || 1; canvas.height = image.naturalHeight || 1;
  canvas.getContext("2d").drawImage(image, 0, 0);
  image.src = canvas.toDataURL("image/jpeg");
};
document.addEventListener("visibilitychange", () => { if (!paused) stream(); });

// --- gauges
function gauges() {
  const row = rows[rows.length - 1];
  $("rate").textContent = shown(state.rate_hz, 0);
  $("find").textContent = state.find_ms_max > 0 ? shown(state.find_ms_max, 2) + " ms" : "–";  // a replay judges nothing
  if (!row) return;
  $("status").textContent = row.status;
  $("status").className = row.status === "found" ? "good" : "bad";
  $("confidence").textContent = shown(row.confidence);
  $("azimuth").textContent = row.azimuth == null ? "–" : shown(row.azimuth, 1) + "°";
  $("yaw").textContent = row.yaw_rate == null ? "–" : shown(row.yaw_rate) + " rad/s";
  $("command").textContent = row.command || "–";
  $("speed").textContent = row.speed == null ? "–" : shown(100 * row.speed, 0) + " %";
  $("flags").textContent = row.flags || "none";
  const dial = $("dial"), c = dial.getContext("2d"), w = dial.width = dial.clientWidth, h = dial.height = 48;
  c.strokeStyle = colour("--line"); c.lineWidth = 2;
  c.beginPath(); c.moveTo(0, 30); c.lineTo(w, 30); c.moveTo(w / 2, 18); c.lineTo(w / 2, 42); c.stroke();
  c.fillStyle = colour("--faint"); c.font = "12px system-ui, sans-serif";
  c.fillText("−45°", 2, 14); c.fillText("0", w / 2 - 3, 14); c.fillText("+45°", w - 32, 14);
  if (row.azimuth != null) {
    const x = w / 2 + Math.max(-45, Math.min(45, row.azimuth)) / 45 * (w / 2 - 8);
    c.fillStyle = colour("--good"); c.beginPath(); c.arc(x, 30, 8, 0, 7); c.fill();
  }
  dial.setAttribute("aria-label", row.azimuth == null ? "No opening: " + row.status
    : `Opening ${shown(Math.abs(row.azimuth), 0)} degrees to the ${row.azimuth < 0 ? "left" : "right"}`);
}

/// What is old must not look like now.
function age() {
  const old_ms = performance.now() - freshAt, old = old_ms > patience_ms;
  $("now").classList.toggle("old", old);
  $("since").hidden = !old;
  $("since").textContent = `no answer since ${Math.floor(old_ms / 1000)} s`;
}
setInterval(age, 500);

// --- charts of the last minute
const charts = [];
function makeCharts() {
  for (const chart of charts.splice(0)) chart.destroy();
  const axis = { stroke: colour("--faint"), grid: { stroke: colour("--line"), width: 1 }, ticks: { stroke: colour("--line") } };
  const chart = (id, range, all) => charts.push(new uPlot({
    width: $(id).clientWidth, height: 150, scales: { x: { time: false }, y: { range } },
    axes: [{ ...axis, size: 30, values: (u, ticks) => ticks.map(t => t + " s") }, { ...axis, size: 52 }],
    series: [{ label: "time", value: (u, v) => shown(v, 1) + " s" }, ...all.map(([label, name, dash]) => ({ label, stroke: colour(name), dash,
      width: 1.25, points: { show: false }, value: (u, v) => shown(v, 3) }))],
  }, [[], ...all.map(() => [])], $(id)));
  chart("chart-s", (u, low, high) => low == null ? [-0.5, 0.5] : [Math.min(low, -0.2), Math.max(high, 0.2)],
    [["sx", "--blue"], ["sy", "--orange"]]);
  chart("chart-c", [-1.04, 1.04], [["confidence", "--green"], ["yaw rate, rad/s", "--violet"], ["speed, share", "--orange", [6, 4]]]);
}
function fillCharts() {
  const time = rows.map(row => row.time);
  charts[0].setData([time, rows.map(r => r.sx), rows.map(r => r.sy)]);
  charts[1].setData([time, rows.map(r => r.confidence), rows.map(r => r.yaw_rate), rows.map(r => r.speed)]);
}

// --- from above
let ground = null, way = [];
const step_m = 0.1, wayLongest = 8000;
/// Of a way as long as anybody waits, a line that stays short enough to draw.
function addToWay(x, y) {
  const end = way[way.length - 1];
  if (end && Math.hypot(x - end[0], y - end[1]) < step_m) return;
  way.push([x, y]);
  if (way.length > wayLongest) way = way.filter((_, i) => i % 2 === 0);
}
function drawPlan() {
  const row = rows[rows.length - 1];
  if (!row || row.x == null) return;
  const canvas = $("plan"), c = canvas.getContext("2d"), w = canvas.clientWidth, h = canvas.clientHeight;
  const ratio = devicePixelRatio || 1, [x0, y0, cell] = state.plan;
  canvas.width = w * ratio; canvas.height = h * ratio;
  c.scale(ratio, ratio);
  let m_px = 0.06, cx = row.x, cy = row.y;
  if (ground && !$("follow").checked) {
    m_px = Math.max(ground.width * cell / w, ground.height * cell / h);
    cx = x0 + ground.width * cell / 2;
    cy = y0 + ground.height * cell / 2;
  }
  const X = x => w / 2 + (x - cx) / m_px, Y = y => h / 2 - (y - cy) / m_px;
  if (ground) c.drawImage(ground, X(x0), Y(y0 + ground.height * cell), ground.width * cell / m_px, ground.height * cell / m_px);
  c.strokeStyle = "#6c8ebf"; c.lineWidth = 2; c.beginPath();
  way.forEach(([x, y], i) => i ? c.lineTo(X(x), Y(y)) : c.moveTo(X(x), Y(y)));
  c.stroke();
  const arrow = (angle, length, stroke) => {
    const ax = X(row.x), ay = Y(row.y), bx = ax + length * Math.cos(angle), by = ay - length * Math.sin(angle);
    c.strokeStyle = c.fillStyle = stroke; c.lineWidth = 3;
    c.beginPath(); c.moveTo(ax, ay); c.lineTo(bx, by); c.stroke();
    c.beginPath(); c.moveTo(bx, by);
    for (const side of [-2.6, 2.6]) c.lineTo(bx + 10 * Math.cos(angle + side), by - 10 * Math.sin(angle + side));
    c.fill();
  };
  if (row.azimuth != null) arrow(row.heading - row.azimuth * Math.PI / 180, 48, "#2fb457");
  arrow(row.heading, 30, "#e5484d");
  canvas.setAttribute("aria-label", `The world seen from above: x ${shown(row.x, 1)} m, y ${shown(row.y, 1)} m`);
}
function takePlan() {
  $("plan-section").hidden = false;
  const image = new Image();
  image.onload = () => { ground = image; drawPlan(); };
  image.src = "plan.png";
}
$("follow").onchange = drawPlan;

// --- settings
function holdSettings(hold) {
  for (const input of document.querySelectorAll(".field input, .field select")) input.disabled = hold;
}
const fields = new Map();  // by "section.name"
async function askSettings() {
  const seen = settingsSeen = state.settings;
  try {
    const sections = await (await fetch("settings")).json();
    if (fields.size) {  // somebody else may have changed them
      for (const { section, fields: now } of sections)
        for (const { name, value } of now) fields.get(section + "." + name)?.take(value);
      return;
    }
    $("flown").hidden = !state.has_plan;
    $("settings-section").hidden = false;
    $("settings").replaceChildren(...sections.map(({ section, fields }, i) => {
      const part = document.createElement("details"), head = document.createElement("summary"), grid = document.createElement("div");
      part.open = i === 0;
      head.textContent = section;
      grid.className = "fields";
      grid.append(...fields.map(field => fieldOf(section, field)));
      part.append(head, grid);
      return part;
    }));
  } catch (error) {
    if (settingsSeen === seen) settingsSeen = null;  // the next look asks again
  }
}
function fieldOf(section, field) {
  const box = document.createElement("div"), label = document.createElement("label"), note = document.createElement("small");
  const id = section + "." + field.name, input = document.createElement(field.choices.length ? "select" : "input");
  box.className = "field";
  input.id = id;
  label.htmlFor = id;
  label.textContent = field.name + (field.unit ? `, ${field.unit}` : "");
  note.id = id + "-note";
  note.textContent = field.meaning + (field.choices.length ? "" : ` ${field.minimum} to ${field.maximum}.`);
  input.setAttribute("aria-describedby", note.id);
  if (field.choices.length) input.append(...field.choices.map(choice => new Option(choice, choice)));
  else { input.type = "text"; input.inputMode = "decimal"; }
  input.value = field.value;
  const mark = () => box.classList.toggle("changed", input.value !== field.default);
  mark();
  fields.set(id, { take(value) {
    if (input.value === field.value) input.value = value;  // what is being typed stays
    field.value = value;
    mark();
  } });
  input.onchange = async () => {
    const response = await fetch("settings", { method: "POST", body: JSON.stringify({ [id]: input.value }) });
    const text = (await response.text()).trim();
    $("said").textContent = response.ok ? `${id} is ${input.value}` : text;
    $("said").className = response.ok ? "good" : "bad";
    if (response.ok) field.value = input.value; else input.value = field.value;
    mark();
  };
  box.append(label, input, note);
  return box;
}
$("only").onchange = () => {
  for (const box of document.querySelectorAll(".field")) box.hidden = $("only").checked && !box.classList.contains("changed");
  for (const part of document.querySelectorAll("#settings details"))
    part.hidden = $("only").checked && !part.querySelector(".field.changed");
};

// --- the look
/// Another adit answers at this address: nothing of before is to be mixed with it.
function beginAnew() {
  began = state.began;
  last = 0; rows = []; way = []; ground = null; settingsSeen = null;
  fields.clear();
  $("settings").replaceChildren();
  $("settings-section").hidden = $("plan-section").hidden = true;
}
function takeRows() {
  const fresh = state.rows.map(r => ({ number: r[0], time: r[1], status: r[2], confidence: r[3], sx: r[4], sy: r[5],
    azimuth: r[6], yaw_rate: r[7], command: r[8], flags: r[9], speed: r[11], x: r[12], y: r[13], heading: r[14] }));
  if (!fresh.length) return;
  freshAt = performance.now();
  for (const row of fresh) {
    if (rows.length && row.time <= rows[rows.length - 1].time) rows = [], way = [];  // it began again
    rows.push(row);
    if (row.x != null) addToWay(row.x, row.y);
  }
  last = fresh[fresh.length - 1].number;
  const old = rows[rows.length - 1].time - span_s;
  rows = rows.slice(Math.max(0, rows.findIndex(row => row.time >= old)));
}
async function look() {
  try {
    const response = await fetch(`state?after=${last}&stream=${streamNumber}`, { signal: AbortSignal.timeout(2 * patience_ms) });
    if (!response.ok) throw new Error(await response.text());
    state = await response.json();
    if (began !== null && state.began !== began) beginAnew();  // its rows come with the next look
    else takeRows();
    began = state.began;
    mendStream(response.headers.get("Adit-Streaming") === "1");
    $("source").textContent = state.source;
    $("line").textContent = state.line;
    $("line").className = "faint";
    $("foot").textContent = `adit ${state.version}, ${state.frames} frames`;
    if (state.settings !== settingsSeen && (state.settable || fields.size)) askSettings();
    holdSettings(!state.settable);
    if (state.has_plan && $("plan-section").hidden) takePlan();
    if (!paused) { gauges(); fillCharts(); drawPlan(); }
  } catch (error) {
    $("line").textContent = "adit has ended, or cannot be reached";
    $("line").className = "bad";
  }
  age();
  setTimeout(look, document.hidden ? 2000 : look_ms);
}
makeCharts();
stream();
look();
let width = innerWidth;
addEventListener("resize", () => { if (innerWidth !== width) { width = innerWidth; makeCharts(); if (state) fillCharts(); drawPlan(); } });
