// What the newest frame and the last minute came to. Follows view.js in one script.
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
