// The look at the server, and what begins it all. Follows view_settings.js in one script.
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
