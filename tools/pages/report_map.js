// The map with poses and commands. Follows report_charts.js in one script.
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
  const yaw = number("yaw_deg", i) * Math.PI / 180, azimuth = number("azimuth_deg", i) * Math.PI / 180;
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
    + `yaw ${shown(number("yaw_deg", at), 0)} degrees`);
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
