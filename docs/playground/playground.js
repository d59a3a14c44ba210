// The page: frames in from a picture, a video or the camera, stages out. All of it stays here.
"use strict";

const $ = (id) => document.getElementById(id);
const video = $("video");
const source = document.createElement("canvas");  // the frame at the width it is judged at
const sourceContext = source.getContext("2d", {willReadFrequently: true});
const page = {frames: 0, fps: 0, find_ms: 0, last: null, ready: false};  // for the curious and for the test
window.adit_playground = page;
let finder = null;
let still = null;       // a picture, judged again when the settings change
let running = 0;        // number of the current source; older loops end
let shown = [];         // times of the last frames
let objectUrl = "";

/** 256 colours from black over red and yellow to white: small is dark. */
const HEAT = (() => {
  const table = new Uint32Array(256);
  for (let i = 0; i < 256; ++i) {
    const t = i / 255;
    const r = Math.min(1, 2.2 * t), g = Math.min(1, Math.max(0, 2.2 * t - 0.7)), b = Math.max(0, 3 * t - 2);
    table[i] = 0xff000000 | (Math.round(255 * b) << 16) | (Math.round(255 * g) << 8) | Math.round(255 * r);
  }
  return table;
})();
const GREY = Uint32Array.from({length: 256}, (_, i) => 0xff000000 | (i << 16) | (i << 8) | i);
const LABELS = [0xff201a16, 0xff3cb4ff, 0xffd09a4f, 0xff7ac36a, 0xffb07ad0, 0xff6fd6e0, 0xffd6d66f, 0xff8f8fff, 0xff9f9f9f,
                0xff5f7fbf, 0xffbf7f5f];

function say(text) {
  $("fault").textContent = text;
}

/** Draws a stage at half its size. @param colourOf value to a colour as a 32-bit number */
function drawStage(canvas, stage, colourOf) {
  const context = canvas.getContext("2d");
  if (!stage) {
    context.clearRect(0, 0, canvas.width, canvas.height);
    return;
  }
  const width = stage.width >> 1, height = stage.height >> 1;
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const picture = context.createImageData(width, height);
  const to = new Uint32Array(picture.data.buffer);
  const values = stage.values;
  for (let y = 0, i = 0; y < height; ++y)
    for (let x = 0, from = 2 * y * stage.width; x < width; ++x, from += 2) to[i++] = colourOf(values[from]);
  context.putImageData(picture, 0, 0);
}

function drawStages() {
  const canvas = (name) => document.querySelector(`[data-stage=${name}]`);
  drawStage(canvas("dark_channel"), finder.stage("dark_channel"), (level) => GREY[level]);
  const depth = finder.stage("closing");
  let least = Infinity, most = -Infinity;
  if (depth)
    for (let i = 0; i < depth.values.length; i += 7) {
      least = Math.min(least, depth.values[i]);
      most = Math.max(most, depth.values[i]);
    }
  const scale = 255 / Math.max(most - least, 1e-9);
  drawStage(canvas("closing"), depth, (d) => HEAT[Math.max(0, Math.min(255, ((d - least) * scale) | 0))]);
  drawStage(canvas("cluster"), finder.stage("cluster"), (c) => HEAT[Math.min(255, 26 * c)]);
  const openings = finder.stage("openings");
  $("answer-name").textContent = openings ? "Openings, the best first" : "Darkest cluster";
  if (openings) drawStage(canvas("answer"), openings, (n) => LABELS[Math.min(n, LABELS.length - 1)]);
  else drawStage(canvas("answer"), finder.stage("binary"), (level) => GREY[level]);
}

function drawFrame(seen) {
  const canvas = $("frame");
  if (canvas.width !== source.width || canvas.height !== source.height) {
    canvas.width = source.width;
    canvas.height = source.height;
  }
  const context = canvas.getContext("2d");
  context.drawImage(source, 0, 0);
  const unit = source.width / 640;
  context.lineWidth = 2 * unit;
  context.strokeStyle = "#4fb4ff";
  if (seen.found)
    for (const o of seen.openings)
      context.strokeRect(o.left_px, o.top_px, o.right_px - o.left_px, o.bottom_px - o.top_px);
  if (seen.found) {
    context.strokeStyle = "#ff2020";
    context.lineWidth = 4 * unit;
    context.beginPath();
    context.arc(seen.u_px, seen.v_px, 14 * unit, 0, 2 * Math.PI);
    context.stroke();
  }
}

function tell(seen) {
  const degrees = (rad) => `${(rad * 180 / Math.PI).toFixed(1)}°`;
  const flags = seen.flags.length ? `; ${seen.flags.join(", ")}` : "";
  $("figures").textContent = seen.found
    ? `found: azimuth ${degrees(seen.azimuth_rad)}, elevation ${degrees(seen.elevation_rad)}, ` +
      `confidence ${seen.confidence.toFixed(2)}${flags}\n${seen.openings.length} opening(s), ` +
      `sx ${seen.sx.toFixed(3)}, sy ${seen.sy.toFixed(3)}`
    : `${seen.status.replaceAll("_", " ")}${flags}\n`;
  const now = performance.now();
  shown.push(now);
  while (now - shown[0] > 1000) shown.shift();
  page.fps = shown.length > 1 ? 1000 * (shown.length - 1) / (now - shown[0]) : 0;
  const rate = still ? "" : `${page.fps.toFixed(0)} frames a second, `;
  $("fps").textContent = `${rate}judged in ${page.find_ms.toFixed(1)} ms (${finder.target})`;
}

/** One frame: judged, and all that is shown of it. */
function take(picture, width, height) {
  const wanted = Math.min(Number($("width").value), width);
  const w = wanted, h = Math.max(16, Math.round(height * wanted / width));
  if (source.width !== w || source.height !== h) {
    source.width = w;
    source.height = h;
  }
  sourceContext.drawImage(picture, 0, 0, w, h);
  const pixels = sourceContext.getImageData(0, 0, w, h);
  const begin = performance.now();
  const seen = finder.find(pixels, true);
  page.find_ms = performance.now() - begin;
  drawFrame(seen);
  drawStages();
  page.frames += 1;
  page.last = seen;
  tell(seen);
}

function follow(number) {
  let lastTime = -1;
  const step = () => {
    if (number !== running) return;
    if (video.readyState >= 2 && video.currentTime !== lastTime) {
      lastTime = video.currentTime;
      try {
        take(video, video.videoWidth, video.videoHeight);
      } catch (error) {
        say(error.message);
        stop();
        return;
      }
    }
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

function stop() {
  ++running;
  still = null;
  shown = [];
  video.pause();
  if (video.srcObject) for (const track of video.srcObject.getTracks()) track.stop();
  video.srcObject = null;
  video.removeAttribute("src");
  if (objectUrl) URL.revokeObjectURL(objectUrl);
  objectUrl = "";
}

async function open(file) {
  stop();
  say("");
  const number = running;
  try {
    if (file.type.startsWith("image/")) {
      still = await createImageBitmap(file);
      take(still, still.width, still.height);
      return;
    }
    objectUrl = URL.createObjectURL(file);
    video.src = objectUrl;
    await video.play();
    follow(number);
  } catch (error) {
    if (number !== running) return;
    stop();
    say(`${file.name}: this browser cannot show it (${error.message}). Pictures: PNG, JPEG, WebP; videos: WebM, MP4.`);
  }
}

async function openCamera() {
  stop();
  say("");
  const number = running;
  try {
    const camera = await navigator.mediaDevices.getUserMedia({video: {width: 640, height: 480, frameRate: 30}});
    if (number !== running) {  // while the browser asked, the page went on to something else
      for (const track of camera.getTracks()) track.stop();
      return;
    }
    video.srcObject = camera;
    await video.play();
    follow(number);
  } catch (error) {
    if (number !== running) return;
    stop();
    say(`The camera cannot be opened: ${error.message}`);
  }
}

function configure() {
  finder.configure({method: $("method").value});
  if (still) take(still, still.width, still.height);
}

function listen() {
  $("file").addEventListener("change", (event) => event.target.files[0] && open(event.target.files[0]));
  $("camera").addEventListener("click", openCamera);
  $("stop").addEventListener("click", stop);
  $("method").addEventListener("change", configure);
  $("width").addEventListener("change", configure);
  for (const name of ["dragenter", "dragover"])
    document.addEventListener(name, (event) => {
      event.preventDefault();
      $("drop").classList.add("over");
    });
  document.addEventListener("dragleave", () => $("drop").classList.remove("over"));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    $("drop").classList.remove("over");
    if (event.dataTransfer.files[0]) open(event.dataTransfer.files[0]);
  });
}

AditFinder.load().then((loaded) => {
  finder = loaded;
  configure();
  listen();
  page.ready = true;
}).catch((error) => say(`adit cannot start here: ${error.message}`));
