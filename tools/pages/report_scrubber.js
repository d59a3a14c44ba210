// Events, scrubber and keys; then everything is laid out. Follows report_map.js in one script.
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

function layOut() { makeCharts(); drawMap(); }
makeCharts();
setUpMap();
listEvents();
go(0);
let width = innerWidth;
addEventListener("resize", () => { if (innerWidth !== width) { width = innerWidth; layOut(); } });
dark.addEventListener("change", layOut);
document.documentElement.dataset.readyMs = String(Math.round(performance.now() - began));
