// The picture of an irregularity: its profile, and its density beside the spectrum it is drawn from.

import { request } from "./api.js";
import { Chart } from "./chart.js";
import { digits } from "./format.js";
import { $, html, show } from "./html.js";

const PAUSE_MS = 350;
const MOST = 24; // conditions to choose from
const WAVES = 10; // of the longest, that the profile shows at first
const WAVES_OF_DENSITY = 40;
const SHORTEST_WAVES = 4000; // that one request may span
const FLOOR = 1e-4; // of the largest density: below is what windows leak

let [last, timer, asked] = ["", 0, null];
const charts = {};

/** One irregularity of each condition, as preview_irregularity takes it, with its name. */
const conditions = (rail) => {
  const { kind, spectrum, profile_id, seed } = rail;
  const each = (values, make) => (values ?? []).flatMap(make);
  if (kind === "harmonic") return each(rail.wavelength_m, (wavelength_m) => each(rail.amplitude_mm, (amplitude_mm) => [{ label: `${wavelength_m} m, ${amplitude_mm} mm`, rail: { kind, wavelength_m, amplitude_mm } }]));
  if (kind === "spectrum") return each(rail.percentile, (percentile) => each(rail.wavelength_band_m, (band) => [{ label: `${percentile} %, ${band.min}–${band.max} m`, rail: { kind, spectrum, percentile, seed, wavelength_band_m: band } }]));
  if (kind === "measured" && profile_id) return each(rail.wavelength_band_m ?? [null], (band) => [{ label: band ? `${band.min}–${band.max} m` : "all wavelengths", rail: { kind, profile_id, ...(band && { wavelength_band_m: band }) } }]);
  return [];
};

/** Show the irregularity of a study, soon, if it is another than the last. */
export const preview = (rail, profiles) => {
  const found = conditions(rail ?? {}).slice(0, MOST);
  const now = JSON.stringify(found);
  if (now === last) return;
  last = now;
  clearTimeout(timer);
  $("preview").hidden = !found.length;
  if (!found.length) return;
  const kept = Math.min(Math.max(0, $("shown").selectedIndex), found.length - 1);
  show($("shown"), html`${found.map(({ label }, n) => html`<option value="${n}">${label}</option>`)}`);
  $("shown").selectedIndex = kept;
  $("shown-field").hidden = found.length < 2;
  const draw = () => picture(found[$("shown").selectedIndex].rail, profiles);
  $("shown").onchange = draw;
  if (!charts["profile-chart"]) $("preview-facts").textContent = "The picture is being drawn.";
  timer = setTimeout(draw, PAUSE_MS);
};

/** Which stretch to show at first, and over which to take the density. */
const stretch = (rail, profiles) => {
  const stored = profiles.find(({ id }) => id === rail.profile_id);
  const band = rail.wavelength_band_m ?? { min: rail.wavelength_m ?? stored?.wavelength_min_m, max: rail.wavelength_m ?? stored?.wavelength_max_m };
  const most = SHORTEST_WAVES * band.min;
  if (stored) return { start_m: stored.start_m, length_m: Math.min(stored.end_m - stored.start_m, most), whole: Math.min(stored.end_m - stored.start_m, most) };
  return { start_m: 0, length_m: Math.max(1, Math.min(WAVES * band.max, most)), whole: Math.max(1, Math.min(WAVES_OF_DENSITY * band.max, most)) };
};

const ask = (irregularity, start_m, length_m, max_points) =>
  request("POST", "/v1/irregularity-previews", { body: { irregularity, start_m, length_m, max_points }, signal: asked.signal });

const picture = async (rail, profiles) => {
  asked?.abort();
  asked = new AbortController();
  const pure = rail.kind === "harmonic"; // windows would make a hill of its single line
  const { start_m, length_m, whole } = stretch(rail, profiles);
  try {
    const [part, all] = await Promise.all([ask(rail, start_m, length_m, 1200), ask(rail, start_m, whole, 2)]);
    $("preview-facts").textContent = `rms ${digits(all.rms_mm, 3)} mm, from ${digits(all.lowest_mm, 3)} to ${digits(all.highest_mm, 3)} mm over ${digits(whole, 3)} m; positive downwards${pure ? `; all of it at ${digits(1 / rail.wavelength_m, 3)} per metre, so that no density is drawn` : ""}`;
    const again = async (from, to) => {
      const finer = await ask(rail, from, Math.max(1, to - from), 1200).catch(() => null);
      if (!finer) return;
      drawProfile(finer, again);
      $("whole").hidden = false;
    };
    $("whole").onclick = () => {
      drawProfile(part, again);
      $("whole").hidden = true;
    };
    $("whole").onclick();
    $("density-chart").hidden = pure;
    if (!pure) drawDensity(all);
  } catch (error) {
    if (error.name !== "AbortError") $("preview-facts").textContent = error.message; // fields tell the rest
  }
};

const draw = (id, spec) => (charts[id] ? charts[id].show(spec) : (charts[id] = new Chart($(id), spec)));

const drawProfile = ({ profile }, zoomed) =>
  draw("profile-chart", {
    label: "Profile of the rail head", height: 250, x: { label: "along the track, m", values: profile.positions_m },
    y: { label: "height, mm" }, series: [{ label: "height", values: profile.heights_mm, points: false }], zoomed,
  });

const drawDensity = ({ density, drawn_from }) => {
  const column = ({ frequencies_per_m, densities_m3 }) => [frequencies_per_m, densities_m3.map((value) => value * 1e6)];
  const [x, found, drawn] = uPlot.join([column(density), ...(drawn_from ? [column(drawn_from)] : [])]);
  const largest = Math.max(...found.filter((value) => value !== undefined && value !== null));
  const kept = x.map((_, n) => (found[n] ?? 0) > FLOOR * largest || drawn?.[n]);
  const only = (values) => values.filter((_, n) => kept[n]).map((value) => value ?? null);
  draw("density-chart", {
    label: "Power spectral density of the profile", height: 250, x: { label: "spatial frequency, 1/m", values: only(x), log: true },
    y: { label: "density, mm²·m", log: true },
    series: [
      { label: "of the profile", values: only(found.map((value) => (value > FLOOR * largest ? value : null))), points: false },
      ...(drawn ? [{ label: "spectrum", values: only(drawn), hue: 1, dash: 1, points: false }] : []),
    ],
  });
};
