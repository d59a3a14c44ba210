// Status over time, under the charts and with their axis. Follows report_charts.js in one script.
const statusColours = { found: "#2fb457", "": "#6b7280", no_opening: "#e5484d", dust: "#c79b3b", too_dark: "#7c4dff",
  too_bright: "#ffd23f", no_contrast: "#b08968", blocked_lens: "#ff8ef3", unreadable: "#111111" };
const statusColour = name => statusColours[name] || "#ff9f40";
const kStrip_px = 14;

/// Which status each pixel of the span on show has: a refusal of one frame must not vanish between pixels.
function worstAcross(width, from_s, to_s) {
  const codes = words.status.codes, known = words.status.known, worst = new Int16Array(width).fill(-1);
  const first = lastAt(time, from_s), last = lastAt(time, to_s), scale = width / (to_s - from_s);
  for (let row = first; row <= last; ++row) {
    const x = Math.max(0, Math.min(width - 1, Math.floor((time[row] - from_s) * scale)));
    if (worst[x] < 0 || known[worst[x]] === "found") worst[x] = codes[row];
  }
  return worst;
}
function drawStatus(u) {
  const { left, top, width, height } = u.bbox, c = u.ctx, { min, max } = u.scales.x;
  if (!(max > min)) return;
  const worst = worstAcross(Math.round(width), min, max), known = words.status.known;
  let status = worst.find(code => code >= 0);
  worst.forEach((code, x) => {
    if (code >= 0) status = code;
    c.fillStyle = statusColour(known[status]);
    c.fillRect(left + x, top, 1, height);
  });
}
function makeStatus() {
  const codes = words.status.codes, known = words.status.known;
  $("status").textContent = "";
  addPlot($("status"), "Status over time", {
    height: kStrip_px + 30, padding: [0, null, 0, null], scales: { x: { time: false }, y: { range: [0, 255] } },
    across: { values: () => [], splits: () => [], grid: { show: false }, ticks: { show: false } },
    series: [{ label: "status", paths: () => null, points: { show: false }, value: (u, v) => v == null ? "" : known[v] || "no frame" }],
    hooks: { draw: [drawStatus] },
  }, [time, codes]);
  $("status-keys").replaceChildren(...known.filter((name, i) => codes.includes(i)).map(name => {
    const key = document.createElement("span"), mark = document.createElement("i");
    mark.style.background = statusColour(name);
    key.append(mark, name || "no frame");
    return key;
  }));
}
