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
/// A plot over time in a box of its own, linked to all others: cursor, zoom, and a click that goes to the frame.
function addPlot(parent, label, options, data) {
  const chart = document.createElement("div");
  chart.setAttribute("role", "img");
  chart.setAttribute("aria-label", label);
  parent.append(chart);
  const axis = timeAxis(), sync = uPlot.sync("time");
  const plot = new uPlot({
    width: parent.clientWidth, legend: { live: true }, ...options,
    cursor: { sync: { key: sync.key, setSeries: false }, drag: { x: true, y: false } },
    axes: [{ ...axis, size: 30, values: (u, ticks) => ticks.map(t => t + " s") }, { ...axis, size: 56, ...options.across }],
    series: [{ label: "time", value: (u, v) => v == null ? "" : v.toFixed(2) + " s" }, ...options.series],
    hooks: { ...options.hooks, ready: [u => {
      u.now = document.createElement("div");
      u.now.className = "now";
      u.over.append(u.now);
      drawNow(u);
    }], setScale: [u => { if (u.now) drawNow(u); }] },
  }, data, chart);
  plot.over.addEventListener("click", () => {
    // A drag ends in a click too; it has a selection.
    if (plot.cursor.idx != null && !plot.dragged) go(plot.cursor.idx);
  });
  plot.over.addEventListener("mousedown", e => { plot.downAt = e.clientX; plot.dragged = false; });
  plot.over.addEventListener("mouseup", e => { plot.dragged = Math.abs(e.clientX - plot.downAt) > 3; });
  plots.push(plot);
}
const timeAxis = () =>
  ({ stroke: colour("--faint"), grid: { stroke: colour("--line"), width: 1 }, ticks: { stroke: colour("--line") } });
function makeCharts() {
  for (const plot of plots.splice(0)) plot.destroy();
  $("charts").textContent = "";
  for (const [title, all, range] of groups) {
    const there = all.filter(s => columns[s.name] && columns[s.name].some(Number.isFinite));
    if (!there.length) continue;
    const box = document.createElement("div"), head = document.createElement("p");
    head.textContent = title;
    head.className = "faint";
    box.append(head);
    $("charts").append(box);
    addPlot(box, "Chart: " + title, {
      height: 140, scales: { x: { time: false }, y: range ? { range } : { range: spread } },
      series: there.map(s => ({ label: s.label, stroke: colour(s.stroke), width: 1.25, dash: s.dash, spanGaps: false,
        points: { show: false }, value: (u, v) => shown(v, 3) })),
    }, [time, ...there.map(s => columns[s.name])]);
  }
  makeStatus();
}
/// From the least to the largest of what is on show, with some room. uPlot's own ends are lost where a column begins with
/// nothing.
function spread(u) {
  const [first, last] = u.series[0].idxs || [0, rows - 1];
  let low = Infinity, high = -Infinity;
  for (let s = 1; s < u.series.length; ++s)
    for (let row = first; u.series[s].show && row <= last; ++row) {
      const value = u.data[s][row];
      if (value < low) low = value;
      if (value > high) high = value;
    }
  if (low > high) return [-1, 1];
  const room = Math.max(0.05 * (high - low), 0.02);
  return [low - room, high + room];
}
/// The line at the frame on show lies over the plot: an hour of rows is not drawn again for it.
function drawNow(u) {
  const x = u.valToPos(time[at], "x");
  u.now.style.left = x + "px";
  u.now.hidden = !(x >= 0 && x <= u.over.clientWidth);
}
