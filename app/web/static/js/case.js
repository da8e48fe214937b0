// Case: what went into it, where its numbers come from, and what they are.

import { address, get, getOnce, Problem, request } from "./api.js";
import { asked, channels } from "./channels.js";
import { Drawing } from "./drawing.js";
import { digits, duration, given, instant, percent, shownUnit, words } from "./format.js";
import { $, html, idle, ready, show } from "./html.js";
import { notify } from "./page.js";
import { showRequests } from "./request.js";
import { Table } from "./table.js";

const AGAIN_MS = 2000;
const id = Number(location.pathname.split("/").pop());
const path = `/v1/cases/${id}`;
const pause = () => new Promise((resolve) => setTimeout(resolve, AGAIN_MS));
const fact = (name, value, title) => html`<div><dt>${name}</dt><dd title="${title ?? ""}">${value}</dd></div>`;

const start = async () => {
  let [found, quantities] = await Promise.all([get(path), getOnce("/v1/quantities")]);
  const titles = new Map(quantities.items.map(({ name, title }) => [name, title]));
  showConditions(found);
  const inputs = showInputs(found);
  for (; ; found = await get(path)) {
    showState(found);
    ready();
    if (!["queued", "running"].includes(found.state)) break;
    await pause();
  }
  await Promise.all([found.history ? showHistory(found, titles) : tellNoHistory(), showPeaks(quantities.items, found), inputs]);
  tellRequests();
  if (found.state === "succeeded") await verification();
};

const showConditions = ({ speed_kmh, slab, irregularity, ...found }) => {
  const told = [["Wavelength", found.wavelength_m, "m"], ["Amplitude", found.amplitude_mm, "mm"], ["Spectrum", found.spectrum, ""], ["Percentile", found.percentile, "%"], ["Seed", found.seed, ""], ["Realisation", found.realisation, ""]];
  $("title").textContent = `Case ${id}: ${given(speed_kmh)} km/h, ${slab} slab`;
  document.title = `Case ${id} · TrackSweep`;
  show($("conditions"), html`${fact("Speed", `${given(speed_kmh)} km/h`)}${fact("Slab", slab)}${fact("Irregularity", irregularity)}
    ${told.filter(([, value]) => value !== null).map(([name, value, unit]) => fact(name, `${given(value)} ${unit}`))}
    ${found.wavelength_min_m !== null && fact("Band", `${given(found.wavelength_min_m)} to ${given(found.wavelength_max_m)} m`)}`);
};

const showInputs = async ({ inputs }) => {
  const { parameters } = await getOnce("/v1/limits");
  const value = (name) => name.split(".").reduce((node, key) => node?.[key], inputs);
  const row = ({ path: name, meaning, unit }) => html`<tr><td>${meaning}</td><td><code>${name}</code></td><td class="number">${typeof value(name) === "number" ? given(Number(value(name).toPrecision(7))) : "–"}</td><td>${unit}</td></tr>`;
  show($("inputs"), html`<table><thead><tr><th scope="col">Value of</th><th scope="col">Name</th><th scope="col" class="number">Value</th><th scope="col">Unit</th></tr></thead><tbody>${parameters.map(row)}</tbody></table>`);
};

const showState = (found) => {
  const { state, error, progress, history } = found;
  show($("state"), html`<span class="state ${state}">${state}</span>${state === "running" && ` ${percent(progress)}`}${error && html` <span class="error">${error.code}: ${error.detail}</span>`}`);
  show($("provenance"), html`${fact("Digest", html`<code>${found.digest.slice(0, 12)}</code>`, found.digest)}${fact("Solver version", found.solver_version)}
    ${fact("Attempts", found.attempt)}${fact("Worker", found.worker ?? "–")}${fact("Processor time", duration(found.cpu_s))}
    ${fact("Asked for", instant(found.created_at))}${fact("Begun", instant(found.started_at))}${fact("Ended", instant(found.finished_at))}
    ${history && fact("History", `${digits(history.size_bytes / 1e6, 3)} MB`, history.digest)}`);
  show($("actions"), history ? html`<a class="button" download="case-${id}.npz" href="${address(`${path}/history.npz`, { through: "service" })}">History as NumPy</a><a class="button" download="case-${id}.parquet" href="${address(`${path}/history.parquet`)}">as Parquet</a>` : "");
};

const showPeaks = async (quantities, { state }) => {
  const { items } = await get(`${path}/peaks`);
  if (!items.length) return show($("peaks"), html`<p class="empty">${state === "succeeded" ? "There are none." : "There are none, as the case did not succeed."}</p>`);
  const title = new Map(quantities.map((each) => [each.name, each]));
  const number = (key, label, make = ({ [key]: value, unit }) => value * shownUnit(unit).factor) => ({ key, label, number: true, value: make, text: (row) => digits(make(row)) });
  new Table($("peaks"), "Peaks of the case").show([
    { key: "quantity", label: "Quantity", value: (row) => row.quantity, text: (row) => html`<span title="${title.get(row.quantity)?.convention ?? ""}">${title.get(row.quantity)?.title ?? words(row.quantity)}</span>` },
    { key: "position", label: "at", value: (row) => row.position, text: (row) => words(row.position) },
    { key: "unit", label: "Unit", value: (row) => shownUnit(row.unit).name, text: (row) => shownUnit(row.unit).name },
    ...["peak", "maximum", "minimum", "mean", "std", "rms"].map((key) => number(key, key === "std" ? "std. dev." : key)),
    number("time_s", "peak at, s", (row) => row.time_s), number("track_position_m", "at, m", (row) => row.track_position_m),
  ], items);
};

const showHistory = async (found, titles) => {
  const whole = await channels(id, titles, tellRequests);
  const longest = Math.max(...whole.channels.map(({ time_s }) => time_s.at(-1)));
  await idle();
  new Drawing(id, found, whole, longest);
};

const tellNoHistory = () => {
  $("drawing-sheet").hidden = $("spectrum-sheet").hidden = true;
  show($("histories"), html`<p class="empty">No history of this case is stored. <a href="${address("/studies/new")}">Create a study</a> of it that keeps time histories: it is then computed once more.</p>`);
};

const tellRequests = () => {
  const of = { parameters: { case_id: id } };
  showRequests($("request"), [
    { operation: "cases.get_case", path: "/v1/cases/{case_id}", ...of },
    { operation: "peaks.list_case_peaks", path: "/v1/cases/{case_id}/peaks", ...of },
    ...(asked.spectrum ? [
      { operation: "histories.get_history", path: "/v1/cases/{case_id}/history", ...of, query: asked.history },
      { operation: "histories.get_spectrum", path: "/v1/cases/{case_id}/spectrum", ...of, query: asked.spectrum },
    ] : []),
  ]);
};

/** Show what came of the latest verification, and let the reader ask for one. */
const verification = async () => {
  let found = await get(`${path}/verification`).catch((error) => {
    if (error instanceof Problem && error.status === 404) return null;
    throw error;
  });
  for (; ; found = await get(`${path}/verification`)) {
    const waits = found && !found.finished_at;
    show($("verification"), html`<button type="button" id="verify">Compute once more and compare</button><span>${verified(found)}</span>`);
    $("verify").disabled = waits;
    $("verify").onclick = () => request("POST", `${path}/verification`).then(verification).catch(notify);
    if (!waits) return;
    await pause();
  }
};

const verified = (found) => {
  if (!found) return "";
  if (!found.finished_at) return "It is computed once more when no queued case waits.";
  if (found.error) return `${instant(found.finished_at)}: ${found.error.detail}`;
  const largest = Object.entries(found.differences ?? {}).toSorted(([, a], [, b]) => b - a)[0];
  const difference = largest ? `, largest difference ${largest[1] === 0 ? "0" : `${digits(largest[1], 2)} of ${words(largest[0])}`}` : "";
  return `${instant(found.finished_at)}: ${found.outcome === "same" ? "the same numbers" : found.outcome}${difference}`;
};

start().catch((error) => {
  ready();
  if (!(error instanceof Problem) || error.status !== 404) return notify(error);
  $("case").hidden = true;
  $("absent").hidden = false;
  show($("absent"), html`<p class="empty">${error.message} <a href="${address("/")}">Look through the studies</a>.</p>`);
});
