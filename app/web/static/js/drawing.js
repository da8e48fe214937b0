// Vehicle and track at an instant, as far as a history holds them: forces and accelerations where they act; deflections
// of rail, slab and base as recorded under the first wheelset and, between, as forces at rest would bend the track.

import { get } from "./api.js";
import { digits, quantity } from "./format.js";
import { $, html, show } from "./html.js";
import { notify } from "./page.js";

const QUANTITIES = [
  "wheel_rail_force", "rail_displacement", "slab_displacement", "base_displacement",
  "car_body_acceleration", "bogie_acceleration", "wheelset_acceleration",
];
const CHUNK_S = 0.25; // that one request brings
const POINTS = 500;
const AHEAD_M = 8; // of track shown on either side of the outer wheels
const FAR_M = 40; // where forces bend nothing
const GRID_M = 0.1;
const STEP_M = 0.2; // of the lines
const [WAVENUMBERS, LARGEST] = [400, 14]; // rad/m
const HEIGHT = 316;
const LEVELS = { rail: 150, slab: 195, base: 240 }; // px
const ROOM = 32; // px that the largest deflection takes
const LONGEST_ARROW = 34;
const APART = 36; // px that the numbers of two wheels need
const GRAVITY = 9.81;

/** Deflections of rail, slab and base at distances from a unit force at rest; half a track, continuous, pads smeared. */
const influence = (t) => {
  const [pad, mortar, roadbed] = [t.pad_stiffness_n_per_m / t.pad_spacing_m, t.mortar_stiffness_n_per_m2, t.roadbed_stiffness_n_per_m2];
  const count = Math.round(FAR_M / GRID_M);
  const found = { rail: new Float64Array(count), slab: new Float64Array(count), base: new Float64Array(count) };
  const step = LARGEST / WAVENUMBERS;
  for (let n = 0; n < WAVENUMBERS; n++) {
    const k = n * step;
    const base = t.base_elastic_modulus_pa * t.base_second_moment_m4 * k ** 4 + mortar + roadbed;
    const below = t.slab_elastic_modulus_pa * t.slab_second_moment_m4 * k ** 4 + pad + mortar - mortar ** 2 / base;
    const rail = ((n ? 1 : 0.5) * step) / Math.PI / (t.rail_elastic_modulus_pa * t.rail_second_moment_m4 * k ** 4 + pad - pad ** 2 / below);
    const [slab, under] = [(rail * pad) / below, ((rail * pad) / below) * (mortar / base)];
    for (let i = 0; i < count; i++) {
      const wave = Math.cos(k * i * GRID_M);
      found.rail[i] += rail * wave;
      found.slab[i] += slab * wave;
      found.base[i] += under * wave;
    }
  }
  return found;
};

/** Draw a case of which a history is stored; `window_s` is how long that is. */
export class Drawing {
  constructor(id, { inputs, speed_kmh, slab }, history, window_s) {
    const { half_bogie_distance_m: a, half_wheelbase_m: b } = inputs.vehicle;
    Object.assign(this, { id, track: inputs.track, vehicle: inputs.vehicle, slab, speed: speed_kmh / 3.6, start: history.track_position_start_m, window_s });
    this.wheels = [a + b, a - b, -a + b, -a - b]; // ahead of the middle
    this.influence = influence(inputs.track);
    const { car_body_mass_kg: body, bogie_mass_kg: bogie, wheelset_mass_kg: wheelset } = inputs.vehicle;
    this.load = (GRAVITY * (body + 2 * bogie + 4 * wheelset)) / 8;
    this.scale = ROOM / (1.5 * this.deflection("rail", this.wheels[0], this.wheels.map(() => this.load)));
    this.chunk = null;
    $("instant").max = window_s;
    this.time = Number($("instant").value); // exactly: a frame goes on by less than a step of the slider
    $("instant").addEventListener("input", () => this.show(Number($("instant").value)));
    $("play").addEventListener("click", () => this.play());
    new ResizeObserver(() => this.show()).observe($("drawing"));
    $("drawing-note").textContent = `Recorded: forces (arrows at the wheels; at rest ${quantity(this.load, "N")}), accelerations, and the dots under the first wheelset. Lines: how these forces would bend a continuous track at rest; histories hold no deflection elsewhere.`;
  }

  get width() {
    return Math.max(280, $("drawing").clientWidth);
  }

  perMetre() {
    return this.width / (2 * (this.wheels[0] + AHEAD_M));
  }

  deflection(beam, x, forces) {
    const of = this.influence[beam];
    const at = (distance) => {
      const n = Math.floor(distance / GRID_M);
      return n + 1 < of.length ? of[n] + (distance / GRID_M - n) * (of[n + 1] - of[n]) : 0;
    };
    return this.wheels.reduce((sum, wheel, n) => sum + forces[n] * at(Math.abs(x - wheel)), 0);
  }

  /** The recorded values at a time, of what is there of it. */
  async at(time) {
    const first = Math.floor(time / CHUNK_S) * CHUNK_S;
    if (this.chunk?.first !== first) {
      const query = { quantity: QUANTITIES, time_min_s: first, time_max_s: first + CHUNK_S, max_points: POINTS };
      this.chunk = { first, ...(await get(`/v1/cases/${this.id}/history`, query)) };
    }
    return new Map(this.chunk.channels.map(({ quantity: name, position, time_s, values }) => {
      const after = time_s.findIndex((each) => each >= time);
      return [`${name} ${position}`, values[after < 0 ? values.length - 1 : after]];
    }));
  }

  async show(time = this.time) {
    this.time = time;
    if (this.busy) return (this.again = true);
    this.busy = true;
    try {
      this.draw(time, await this.at(time));
    } catch (error) {
      this.stop();
      notify(error);
    }
    this.busy = false;
    if (this.again) {
      this.again = false;
      this.show();
    }
  }

  draw(time, value) {
    const position = this.start + this.speed * time;
    const [middle, perMetre] = [this.width / 2, this.perMetre()];
    const px = (x) => middle + x * perMetre;
    const forces = this.wheels.map((_, n) => value.get(`wheel_rail_force wheelset_${n + 1}`));
    const half = this.wheels[0] + AHEAD_M;
    const line = (beam) => {
      const points = [];
      for (let x = -half; x <= half; x += STEP_M) points.push(`${px(x).toFixed(1)},${(LEVELS[beam] + this.scale * this.deflection(beam, x, forces)).toFixed(1)}`);
      return html`<polyline class="${beam}" points="${points.join(" ")}"/>`;
    };
    const level = (beam, x) => LEVELS[beam] + this.scale * this.deflection(beam, x, forces);
    const recorded = ["rail", "slab", "base"].map((beam) => html`<circle class="recorded ${beam}" r="4.5" cx="${px(this.wheels[0])}" cy="${LEVELS[beam] + this.scale * value.get(`${beam}_displacement wheelset_1`)}"/>`);
    const { half_bogie_distance_m: a, half_wheelbase_m: b } = this.vehicle;
    const radius = Math.max(5, this.vehicle.wheel_radius_m * perMetre);
    const wheel = (x, n) => {
      const y = level("rail", x) - radius - 1;
      const arrow = (LONGEST_ARROW * Math.max(0, forces[n])) / (2 * this.load);
      const tip = y - radius - 4;
      const aside = Math.max(0, (APART - 2 * b * perMetre) / 2) * (n % 2 ? -1 : 1); // that numbers do not meet
      return html`<circle class="wheel" r="${radius}" cx="${px(x)}" cy="${y}"/>
        <path class="force" d="M${px(x)} ${tip - arrow}V${tip - 4}"/><path class="force-head" d="M${px(x)} ${tip}l-4 -7h8z"/>
        <text x="${px(x) + aside}" y="274">${digits(forces[n] / 1e3, 3)}</text>
        <text class="soft" x="${px(x) + aside}" y="290">${digits(value.get(`wheelset_acceleration wheelset_${n + 1}`), 2)}</text>`;
    };
    const bogie = (x, n) => {
      const acceleration = value.get(`bogie_acceleration bogie_${n}`);
      return html`<path class="spring" d="M${px(x)} 52V84M${px(x - b)} 93V${level("rail", x - b) - radius}M${px(x + b)} 93V${level("rail", x + b) - radius}"/>
        <rect class="body" x="${px(x - b)}" y="84" width="${2 * b * perMetre}" height="9" rx="3"/><text class="soft left" x="${px(x) + 8}" y="74">${digits(acceleration, 2)} m/s²</text>`;
    };
    const body = value.get("car_body_acceleration car_body");
    show($("drawing"), html`<svg viewBox="0 0 ${this.width} ${HEIGHT}" role="img" aria-label="Vehicle and track at ${digits(time, 4)} s: wheel–rail forces ${forces.map((force) => digits(force / 1e3, 3)).join(", ")} kN">
      ${this.pads(position, half).map((x) => html`<line class="pad" x1="${px(x)}" x2="${px(x)}" y1="${level("rail", x) + 2}" y2="${level("slab", x) - 1}"/>`)}
      ${this.joints(position, half).map((x) => html`<line class="joint" x1="${px(x)}" x2="${px(x)}" y1="${LEVELS.slab - 8}" y2="${LEVELS.slab + 30}"/>`)}
      ${["base", "slab", "rail"].map(line)}${recorded}
      <rect class="body" x="${px(-a - b - 1.5)}" y="12" width="${(2 * (a + b) + 3) * perMetre}" height="40" rx="6"/>
      <text x="${px(0)}" y="28">car body</text><text class="soft" x="${px(0)}" y="44">${digits(body, 2)} m/s²</text>
      ${bogie(a, 1)}${bogie(-a, 2)}${this.wheels.map(wheel)}
      ${["rail", "slab", "base"].map((beam) => html`<text class="soft left" x="4" y="${LEVELS[beam] - 5}">${beam}</text>`)}
      <text class="soft left" x="4" y="274">kN</text>
      <text class="soft left" x="4" y="290">m/s²</text>
      <text class="soft left" x="4" y="310">deflections × ${digits(this.scale / perMetre, 2)}</text></svg>`);
    $("instant-told").textContent = `${time.toFixed(4)} s; first wheelset at ${position.toFixed(2)} m`;
  }

  /** Where pads are, ahead of the middle. */
  pads(position, half) {
    return this.every(this.track.pad_spacing_m, 0, position, half);
  }

  joints(position, half) {
    if (this.slab === "continuous") return [];
    const { position: place, pads_per_slab } = this.track.joint;
    const spacing = this.track.pad_spacing_m;
    return this.every(pads_per_slab * spacing, place * spacing, position, half);
  }

  every(distance, first, position, half) {
    const middle = position - this.wheels[0];
    const found = [];
    for (let n = Math.ceil((middle - half - first) / distance); first + n * distance <= middle + half; n++) found.push(first + n * distance - middle);
    return found;
  }

  play() {
    if (this.frame) return this.stop();
    $("play").textContent = "Pause";
    $("play").setAttribute("aria-pressed", "true");
    let last = performance.now();
    const next = (now) => {
      const time = this.time + (now - last) / 1000 / Number($("slowness").value);
      if (!this.busy) {
        last = now;
        this.show(time >= this.window_s ? 0 : time);
        $("instant").value = this.time;
      }
      this.frame = requestAnimationFrame(next);
    };
    this.frame = requestAnimationFrame(next);
  }

  stop() {
    cancelAnimationFrame(this.frame);
    this.frame = null;
    $("play").textContent = "Play";
    $("play").setAttribute("aria-pressed", "false");
  }
}
