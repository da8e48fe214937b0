// The queue and its workers.

import { address } from "./api.js";
import { count, duration, given, percent } from "./format.js";
import { $, html } from "./html.js";
import { render } from "./page.js";
import { showRequests } from "./request.js";

const fact = (name, value, unit) => html`<div><dt>${name}</dt><dd class="large">${value}${unit && html` <small>${unit}</small>`}</dd></div>`;

const since = (instant) => (instant ? duration((Date.now() - new Date(instant)) / 1000) : "–");

const named = ({ name, draining }) => html`<th scope="row">${name}${draining && html` <small>draining</small>`}</th>`;

const row = (worker) => ({ id, speed_kmh: speed, slab, irregularity, progress, attempt, started_at: started }) => html`<tr>
  ${named(worker)}
  <td class="number"><a id="case-${id}" href="${address(`/cases/${id}`)}">${id}</a></td>
  <td class="number">${given(speed)}</td><td>${slab} slab</td><td>${irregularity}</td>
  <td class="done"><progress max="1" value="${progress}" aria-label="Progress of case ${id}"></progress> <small>${percent(progress)}</small></td>
  <td class="number">${attempt}</td><td class="number">${since(started)}</td></tr>`;

const idle = (worker) => html`<tr>${named(worker)}<td colspan="7" class="soft">${worker.running ? `${count(worker.running)} cases of others` : "waits for work"}</td></tr>`;

const workers = (found) => html`<table><caption class="hidden">Workers</caption>
  <thead><tr><th scope="col">Worker</th><th scope="col" class="number">Case</th><th scope="col" class="number">Speed<small>km/h</small></th><th scope="col">Slab</th>
  <th scope="col">Irregularity</th><th scope="col">Progress</th><th scope="col" class="number">Attempt</th><th scope="col" class="number">For</th></tr></thead>
  <tbody>${found.map((worker) => (worker.cases.length ? worker.cases.map(row(worker)) : idle(worker)))}</tbody></table>`;

const NOBODY = html`<p class="empty">No worker is there: what is queued waits. <code>tracksweep serve</code> runs some, <code>tracksweep worker</code> one.</p>`;

render("queue", ({ queued, running, oldest_queued_at: oldest, throughput, workers: found }) => {
  $("queue").setAttribute("aria-busy", "false");
  showRequests($("request"), [{ operation: "queue.get_queue", path: "/v1/queue" }]);
  return html`<section class="sheet" aria-label="Numbers"><dl class="facts">
    ${fact("Waiting", count(queued), "cases")}${fact("The oldest waits", since(oldest))}${fact("Running", count(running), "cases")}
    ${fact("Workers", count(found.length))}${fact("Last minute", count(throughput.last_minute), "cases")}${fact("Last hour", count(throughput.last_hour), "cases")}
    ${fact("Computing, last hour", duration(throughput.cpu_s_last_hour))}</dl></section>
    <section class="sheet" aria-labelledby="workers-title"><h2 id="workers-title">Workers</h2><div class="scroll" tabindex="0" role="region" aria-labelledby="workers-title">${found.length ? workers(found) : NOBODY}</div></section>`;
});
