// Histories of a case, zoomed together, and the spectrum of one channel.

import { get } from "./api.js";
import { Chart } from "./chart.js";
import { count, digits, given, shownUnit, words } from "./format.js";
import { $, html, inTurns, show } from "./html.js";
import { notify } from "./page.js";

const POINTS = 600; // of a channel, in a chart
const HEIGHT = 190;
const FLOOR = 1e-9; // of the largest density

const charts = new Map();
const before = []; // the parts of the window looked at, the last of them now

/** What was asked last, as the requests that the page shows. */
export const asked = { history: { max_points: POINTS }, spectrum: null };

/** Show all channels of a case, and let the reader choose one for its spectrum. */
export const channels = async (id, titles, told) => {
  let [zooming, reading] = [false, null];
  const read = async (part) => {
    reading?.abort();
    reading = new AbortController();
    asked.history = { max_points: POINTS, ...part };
    const history = await get(`/v1/cases/${id}/history`, asked.history, reading.signal);
    const quantities = Map.groupBy(history.channels, ({ quantity: name }) => name);
    draw([...quantities].map(([name, found]) => [name, found, titles.get(name) ?? words(name), zoom]));
    const [from, to] = ends(history);
    $("part").textContent = `${from.toFixed(4)} to ${to.toFixed(4)} s, ${count(history.samples)} samples per channel, drawn from ${count(Math.min(history.samples, POINTS))}`;
    $("back").disabled = $("whole").disabled = before.length < 2;
    told();
    return history;
  };
  const go = (part) => read(part).catch((error) => error.name !== "AbortError" && notify(error));
  const zoom = (from, to) => {
    if (zooming) return; // every chart that follows the first tells it, too
    zooming = true;
    queueMicrotask(() => (zooming = false));
    const part = { time_min_s: Math.max(0, from), time_max_s: to };
    before.push(part);
    go(part);
  };
  $("back").onclick = () => {
    before.pop();
    go(before.at(-1));
  };
  $("whole").onclick = () => {
    before.length = 1;
    go(before[0]);
  };
  before.push({});
  const whole = await read({});
  show($("channel"), html`${whole.channels.map(({ quantity: name, position }, n) => html`<option value="${n}">${titles.get(name) ?? words(name)}, ${words(position)}</option>`)}`);
  const spectrum = () => drawSpectrum(id, whole.channels[$("channel").value], whole.speed_kmh, told).catch(notify);
  for (const name of ["channel", "resolution", "highest"]) $(name).addEventListener("change", spectrum);
  spectrum();
  return whole;
};

const ends = ({ channels: all }) => {
  const times = all.flatMap(({ time_s }) => [time_s[0], time_s.at(-1)]).filter((time) => time !== undefined);
  return [Math.min(...times), Math.max(...times)];
};

const draw = inTurns(([name, found, title, zoomed]) => {
  const { name: unit, factor } = shownUnit(found[0].unit);
  const [x, ...columns] = uPlot.join(found.map(({ time_s, values }) => [time_s, values.map((value) => value * factor)]));
  const spec = {
    label: `${title}, ${unit}, over time`, height: HEIGHT, sync: "histories", zoomed, x: { label: "time, s", values: x }, y: { label: unit },
    series: found.map(({ position }, n) => ({ label: words(position), values: columns[n], hue: n, points: false })),
  };
  if (charts.has(name)) charts.get(name).show(spec);
  else {
    const place = document.createElement("div");
    show(place, html`<h3>${title}</h3><div></div>`);
    $("histories").append(place);
    charts.set(name, new Chart(place.lastElementChild, spec));
  }
});

let spectrumChart = null;

const drawSpectrum = async (id, { quantity: name, position }, speed_kmh, told) => {
  asked.spectrum = { quantity: name, position, resolution_hz: Number($("resolution").value), frequency_max_hz: Number($("highest").value) };
  const found = await get(`/v1/cases/${id}/spectrum`, asked.spectrum);
  const least = FLOOR * Math.max(...found.density);
  const marks = [{ value: found.p2_hz, label: `P2 ${digits(found.p2_hz, 3)} Hz` }, { value: found.pad_passing_hz, label: `pads ${digits(found.pad_passing_hz, 4)} Hz` }];
  const spec = {
    label: `Spectrum of ${words(name)}, ${words(position)}`, height: 300, marks: marks.filter(({ value }) => value <= asked.spectrum.frequency_max_hz),
    x: { label: "frequency, Hz", values: found.frequency_hz, log: true }, y: { label: found.density_unit.replaceAll("^2", "²"), log: true },
    series: [{ label: "density", values: found.density.map((value) => (value > least ? value : null)), points: false }],
  };
  if (spectrumChart) spectrumChart.show(spec);
  else spectrumChart = new Chart($("spectrum"), spec);
  $("spectrum-note").textContent = `One-sided, Welch: the mean of ${found.segments} Hann ${found.segments === 1 ? "window" : "windows"} that overlap by half, ${given(Number(found.resolution_hz.toPrecision(4)))} Hz apart. A wave of 1 m passes at ${digits(speed_kmh / 3.6, 4)} Hz.`;
  told();
};
