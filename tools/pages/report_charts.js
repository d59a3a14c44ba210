// Charts over time, linked to the scrubber. Follows report.js in one script.
// --- charts
const share = [-0.04, 1.04];  // a line at 0 or 1 is not to lie on the frame
const plots = [], series = (label, name, stroke, extra = {}) => ({ label, name, stroke, ...extra });
const groups = [
  ["sx and sy: right and down of the axis", [series("sx", "sx", "--blue"), series("sy", "sy", "--orange")]],
  ["Azimuth, degrees, positive to the right", [series("answer", "azimuth_deg", "--blue"),
    series("opening followed", "track_azimuth_deg", "--orange"),
    series("passage 5 m ahead", "passage_azimuth_deg", "--grey", { dash: [6, 4] })]],
  ["Confidence", [series("confidence", "confidence", "--green"), series("veil", "veil_fraction", "--violet")], share],
  ["Yaw rate, rad/s, positive to the left", [series("yaw rate", "yaw_rate_rad_s", "--green")]],
  ["Speed, share of what is set", [series("speed", "speed_scale", "--violet")], share],
  ["Side clearance, m", [series("side clearance", "side_clearance_m", "--red")]],
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
      width, height: 140, legend: { live: true },
      scales: { x: { time: false }, y: range ? { range } : { range: spread } },
      cursor: { sync: { key: sync.key, setSeries: false }, drag: { x: true, y: false } },
      axes: [{ ...axis, size: 30, values: (u, ticks) => ticks.map(t => t + " s") }, { ...axis, size: 56 }],
      series: [{ label: "time", value: (u, v) => v == null ? "" : v.toFixed(2) + " s" },
        ...there.map(s => ({ label: s.label, stroke: colour(s.stroke), width: 1.25, dash: s.dash, spanGaps: false,
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
function drawStatusNow() { $("status-now").style.left = 100 * time[at] / (time[rows - 1] || 1) + "%"; }
$("status").addEventListener("click", e => {
  go(lastAt(time, e.offsetX / $("status").clientWidth * time[rows - 1]));
});
