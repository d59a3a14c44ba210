// The finder in WebAssembly (c/include/adit.h) with JavaScript's words.
"use strict";

/* exported AditFinder */
class AditFinder {
  // Offsets of the C structs on wasm32, where pointers and size_t have four bytes. The playground's test compares what
  // is read here with what adit says of the same frame.
  static IMAGE_BYTES = 24;
  static OPEN_SPACE_BYTES = 112;
  static OPENING_BYTES = 144;
  static IMAGES = {dark_channel: 0, scattering_depth: 1, closing: 2, cluster: 3, binary: 4, light: 5, enclosure: 6,
                   openings: 7};
  static FLOATS = new Set(["scattering_depth", "closing", "light", "enclosure"]);

  static async load() {
    return new AditFinder(await createAdit());
  }

  constructor(wasm) {
    this.wasm = wasm;
    this.image = wasm._malloc(AditFinder.IMAGE_BYTES);
    this.openSpace = wasm._malloc(AditFinder.OPEN_SPACE_BYTES);
    this.opening = wasm._malloc(AditFinder.OPENING_BYTES);
    this.sides = wasm._malloc(8);
    this.pixels = 0;
    this.room = 0;
    this.finder = 0;
  }

  get target() {
    return this.wasm.UTF8ToString(this.wasm._adit_cpu_target());
  }

  /** Makes a finder anew. @param fields such as {method: "adit", omega: "0.9"} */
  configure(fields) {
    const w = this.wasm;
    const config = w._adit_config_create();
    try {
      for (const [name, value] of Object.entries(fields))
        this.check(w.ccall("adit_config_set", "number", ["number", "string", "string"], [config, name, String(value)]));
      if (this.finder) w._adit_finder_destroy(this.finder);
      this.finder = 0;
      const out = w._malloc(4);
      const code = w._adit_finder_create(config, 0, out);
      this.finder = w.HEAPU8[out] | (w.HEAPU8[out + 1] << 8) | (w.HEAPU8[out + 2] << 16) | (w.HEAPU8[out + 3] << 24);
      w._free(out);
      this.check(code);
    } finally {
      w._adit_config_destroy(config);
    }
  }

  check(code) {
    if (code !== 0) throw new Error(this.wasm.UTF8ToString(this.wasm._adit_last_error()));
  }

  /** Judges an ImageData. @param explain also keeps the stages' pictures for stage(). */
  find(imageData, explain = false) {
    const w = this.wasm;
    const {width, height, data} = imageData;
    if (data.length > this.room) {
      if (this.pixels) w._free(this.pixels);
      this.pixels = w._malloc(data.length);
      this.room = data.length;
    }
    w.HEAPU8.set(data, this.pixels);
    const view = this.view();
    view.setUint32(this.image, AditFinder.IMAGE_BYTES, true);
    view.setUint32(this.image + 4, this.pixels, true);
    view.setInt32(this.image + 8, width, true);
    view.setInt32(this.image + 12, height, true);
    view.setInt32(this.image + 16, 4 * width, true);
    view.setInt32(this.image + 20, 4, true);  // ADIT_RGBA8
    view.setUint32(this.openSpace, AditFinder.OPEN_SPACE_BYTES, true);
    this.check((explain ? w._adit_finder_explain : w._adit_finder_find)(this.finder, this.image, this.openSpace));
    return this.read();
  }

  read() {
    const view = this.view(), at = this.openSpace;
    const real = (i) => view.getFloat64(at + 24 + 8 * i, true);
    const flags = view.getUint32(at + 12, true);
    const names = ["dust", "glare", "blocked lens", "too dark", "too bright", "dirty lens"];
    const seen = {
      status: this.wasm.UTF8ToString(this.wasm._adit_status_name(view.getInt32(at + 4, true))),
      flags: names.filter((_, bit) => flags & (1 << bit)),
      confidence: real(0), u_px: real(1), v_px: real(2), sx: real(3), sy: real(4), azimuth_rad: real(5),
      elevation_rad: real(6), area_fraction: real(7), openings: [],
    };
    seen.found = seen.status === "found";
    const count = view.getInt32(at + 8, true);
    for (let i = 0; i < count; ++i) seen.openings.push(this.readOpening(i));
    return seen;
  }

  readOpening(index) {
    this.view().setUint32(this.opening, AditFinder.OPENING_BYTES, true);
    this.check(this.wasm._adit_finder_opening(this.finder, index, this.opening));
    const view = this.view();
    const real = (i) => view.getFloat64(this.opening + 16 + 8 * i, true);
    return {u_px: real(0), v_px: real(1), azimuth_rad: real(4), elevation_rad: real(5), confidence: real(7),
            left_px: real(12), top_px: real(13), right_px: real(14), bottom_px: real(15)};
  }

  /** {width, height, values} of a stage of the last explained frame, or null. The values are the finder's own memory. */
  stage(name) {
    const w = this.wasm;
    const at = w._adit_finder_image(this.finder, AditFinder.IMAGES[name], this.sides, this.sides + 4);
    if (!at) return null;
    const view = this.view();
    const width = view.getInt32(this.sides, true), height = view.getInt32(this.sides + 4, true);
    const values = AditFinder.FLOATS.has(name) ? new Float32Array(w.HEAPU8.buffer, at, width * height)
                                               : new Uint8Array(w.HEAPU8.buffer, at, width * height);
    return {width, height, values};
  }

  // The memory may have grown since the last call.
  view() {
    return new DataView(this.wasm.HEAPU8.buffer);
  }
}
