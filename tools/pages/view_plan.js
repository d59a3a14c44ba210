// The world from above. Follows view_gauges.js in one script.
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
