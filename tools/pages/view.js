"use strict";
// The page of `adit view`: a stream of pictures, and the rows that came since the last look, five times a second. One script of
// five files: this, view_gauges.js, view_plan.js, view_settings.js, view_look.js.
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
