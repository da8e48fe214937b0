// One study: live progress, curves, peaks, differences.

import { actions, hasEnded } from "./actions.js";
import { address, all, get, getOnce, Problem, watch } from "./api.js";
import { showDifferences } from "./differences.js";
import { count, digits, duration, given, instant, percent, shownUnit, words } from "./format.js";
import { $, html, show } from "./html.js";
import { notify } from "./page.js";
import { Panel } from "./panel.js";
import { showRequests } from "./request.js";
import { heading } from "./sweep.js";
import { Table } from "./table.js";

const id = location.pathname.split("/").pop();
const path = `/v1/studies/${id}`;
const MANY = 1000; // cases, of which all quantities would be too much at once
const MOST_ROWS = 5000;
const PAUSE_MS = 1500; // between two looks at results that are coming in
const STATISTICS = ["peak", "maximum", "minimum", "mean", "std", "rms"];

let study;
let panel;
const peaks = new Table($("table"), "Peaks by case");
const failures = new Table($("failures-table"), "Cases that failed");

const facts = () => {
  const { state, progress, cases, cases_reused: reused, created_at: created, started_at: started, finished_at: finished, finish, priority, owner, labels } = study;
  const end = finished ? new Date(finished) : Date.now();
  const fact = (name, value) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`;
  show($("facts"), html`${!hasEnded(study) && html`<progress max="1" value="${progress}" aria-label="Progress"></progress>`}<dl class="facts">
    ${fact("State", html`<span class="state ${state}" id="study-state">${words(state)}</span> ${!hasEnded(study) && percent(progress)}`)}
    ${fact("Cases", html`${count(cases.succeeded)} of ${count(cases.total)}${cases.running > 0 && `, ${count(cases.running)} running`}${cases.failed > 0 && html`, <span class="error">${count(cases.failed)} failed</span>`}${cases.cancelled > 0 && `, ${count(cases.cancelled)} cancelled`}`)}
    ${reused > 0 && fact("Were there already", count(reused))}
    ${fact(hasEnded(study) ? "Finished" : "To be finished", hasEnded(study) ? instant(finished) : finish ? html`${instant(finish.expected)} <small>± ${duration((new Date(finish.latest) - new Date(finish.earliest)) / 2000)}</small>` : "no worker is there")}
    ${fact("Took", started ? duration((end - new Date(started)) / 1000) : "–")}
    ${fact("Created", html`${instant(created)}${owner && ` by ${owner}`}`)}
    ${priority !== 0 && fact("Priority", given(priority))}
    ${Object.keys(labels).length > 0 && fact("Labels", Object.entries(labels).map(([key, value]) => html`<span class="label">${key}: ${value}</span>`))}</dl>`);
};

const head = () => {
  $("name").textContent = study.name;
  document.title = `${study.name} · TrackSweep`;
  show($("actions"), [html`<a class="button" href="${address("/studies/new", { like: id })}">Use as a template</a><a class="button" href="${address("/compare", { study: id })}">Compare</a>`, ...actions(study)]);
  window.htmx?.process($("actions")); // which it does by itself when it comes later
};

const results = async () => {
  const { statistic, quantity } = panel.choice;
  const some = study.cases.total > MANY;
  const of = some ? quantity || panel.wanted.quantity || panel.quantities[0].name : null;
  const { conditions } = await get(`${path}/statistics`, { statistic, quantity: of });
  $("results").hidden = !conditions.length;
  $("multiples-title").hidden = some;
  if (conditions.length) {
    panel.show(conditions, some);
    await table();
    await differences();
  }
  requests();
};

const table = async () => {
  const { quantity, position } = panel.choice;
  const query = { study_id: id, quantity, position };
  const { items, complete } = await all("/v1/peaks", query, MOST_ROWS);
  if (!items.length) return;
  const { name: unit, factor } = shownUnit(items[0].unit);
  const fields = ["speed_kmh", "slab", "irregularity", "spectrum", "percentile", "wavelength_min_m", "wavelength_max_m", "wavelength_m", "amplitude_mm", "realisation"];
  const varies = (pick) => new Set(items.map(pick)).size > 1;
  const condition = (name, pick) => ({ key: name, label: heading(name).split(", ")[0], unit: heading(name).split(", ")[1], value: pick, text: (row) => given(pick(row)), number: typeof pick(items[0]) === "number" });
  const repeats = (name) => ["maximum", "minimum"].includes(name) && items.every((row) => row[name] === row.peak); // as forces do
  const columns = [
    { key: "case", label: "case", number: true, value: (row) => row.case_id, text: (row) => html`<a href="${address(`/cases/${row.case_id}`)}">${row.case_id}</a>` },
    ...fields.filter((name) => varies((row) => row[name])).map((name) => condition(name, (row) => row[name])),
    ...Object.keys(items[0].parameters).map((name) => condition(name, (row) => row.parameters[name])),
    ...STATISTICS.filter((name) => !repeats(name)).map((name) => ({ key: name, label: name, unit, number: true, value: (row) => row[name], text: (row) => digits(factor * row[name]) })),
    { key: "time_s", label: "time", unit: "s", number: true, value: (row) => row.time_s, text: (row) => digits(row.time_s, 4) },
  ];
  $("table-title").textContent = complete ? `${count(items.length)} cases` : `The first ${count(MOST_ROWS)} cases`;
  peaks.show(columns, items);
  const file = (kind, label) => html`<a class="button" download="peaks.${kind}" href="${address(`/v1/peaks.${kind}`, { study_id: id })}">${label}</a>`;
  show($("table-actions"), html`${file("csv", "CSV")}${file("parquet", "Parquet")}`);
};

const differences = () => showDifferences(path, panel);

const failed = async () => {
  $("failures").hidden = !study.cases.failed;
  if (!study.cases.failed) return;
  const { items, complete } = await all(`${path}/cases`, { state: "failed" }, MOST_ROWS);
  $("failures-title").textContent = complete ? `${count(items.length)} ${items.length === 1 ? "case" : "cases"} failed` : `The first ${count(MOST_ROWS)} cases that failed`;
  const column = (key, label, text, number = false) => ({ key, label, number, value: (row) => row[key], text });
  failures.show([
    column("id", "case", (row) => html`<a href="${address(`/cases/${row.id}`)}">${row.id}</a>`, true),
    { ...column("speed_kmh", "speed", (row) => given(row.speed_kmh), true), unit: "km/h" },
    column("slab", "slab", (row) => row.slab),
    column("attempt", "attempts", (row) => row.attempt, true),
    column("error", "why", (row) => html`<code>${row.error.code}</code> ${row.error.detail}`),
  ], items);
};

const requests = () => {
  const { quantity, position, statistic } = panel.choice;
  const parameters = { study_id: id };
  const between = $("between").value;
  const following = (url) => `from tracksweep_client import Service\n\nwith Service("${url}") as service:\n    for event in service.watch("${id}"):\n        print(event)`;
  showRequests($("request"), [
    { operation: "peaks.list_peaks", path: "/v1/peaks", query: { ...parameters, quantity, position } },
    { operation: "analysis.summarise_study", path: "/v1/studies/{study_id}/statistics", parameters, query: { statistic, ...(study.cases.total > MANY && { quantity }) } },
    ...(between ? [{ operation: "analysis.compare_study", path: "/v1/studies/{study_id}/comparison", parameters, query: { axis: between, statistic, baseline: $("baseline").value } }] : []),
    { operation: "studies.watch_study", path: "/v1/studies/{study_id}/events", parameters, python: following },
  ]);
};

// What comes in is looked at soon, but not for every case.
let looking = null;
let again = false;
const look = () => {
  again = looking !== null;
  looking ??= Promise.all([results(), failed()]).catch(notify).then(() => new Promise((rest) => setTimeout(rest, PAUSE_MS))).finally(() => {
    looking = null;
    if (again) look();
  });
};

const hear = (event, data) => {
  if (event === "progress") {
    const before = study.state;
    study = { ...study, ...data };
    facts();
    if (before !== study.state) head();
  }
  if (event === "case" || event === "done") look();
  if (event === "done") refresh().catch(notify);
};

const refresh = async () => {
  study = await get(path);
  facts();
  head();
};

let following = false;
const follow = async () => {
  if (following || hasEnded(study)) return;
  following = true;
  await watch(id, hear).finally(() => (following = false));
};

const missing = (problem) => {
  if (!(problem instanceof Problem) || problem.status !== 404) throw problem;
  show($("main"), html`<h1>Study</h1><p class="empty">${problem.message} <a href="${address("/")}">See which there are.</a></p>`);
};

document.addEventListener("changed", () => refresh().then(look).then(follow).catch(missing).catch(notify));
$("differences").addEventListener("change", () => differences().then(requests).catch(notify));

const begin = async () => {
  const [found, quantities] = await Promise.all([get(path), getOnce("/v1/quantities"), getOnce("/v1/limits")]);
  study = found;
  facts();
  head();
  panel = new Panel(quantities.items, (name) => (name === "statistic" || study.cases.total > MANY ? results() : table().then(differences).then(requests)).catch(notify));
  look();
  await follow();
};
begin().catch(missing).catch(notify);
