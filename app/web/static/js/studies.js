// Studies: the list, as the API gives it.

import { actions, hasEnded, studyUrl } from "./actions.js";
import { address, get, getOnce } from "./api.js";
import { count, duration, instant, percent, words } from "./format.js";
import { $, html } from "./html.js";
import { render } from "./page.js";
import { showRequests } from "./request.js";

const chosen = new Set();
const remaining = new Map(); // seconds, of studies under way

const filters = () => Object.fromEntries([...$("filters").querySelectorAll("[name]")].map((each) => [each.name, each.value]));

const took = (study) => {
  if (!study.started_at) return "–";
  return duration(((study.finished_at ? new Date(study.finished_at) : Date.now()) - new Date(study.started_at)) / 1000);
};

const row = (study) => {
  const { id, name, owner, labels, state, progress, cases } = study;
  return html`<tr id="study-${id}">
    <td><input type="checkbox" id="choose-${id}" data-choose="${id}" ${chosen.has(id) && "checked"} aria-label="Choose ${name} for a comparison"></td>
    <td class="name"><a href="${studyUrl(id)}" id="name-${id}">${name}</a> ${owner && html`<span class="label">by ${owner}</span>`} ${Object.entries(labels).map(([key, value]) => html`<span class="label">${key}: ${value}</span>`)}</td>
    <td><span class="state ${state}">${words(state)}</span></td>
    <td class="done">${!hasEnded(study) && html`<progress max="1" value="${progress}" aria-label="Progress of ${name}"></progress>`}${state !== "succeeded" && html`<small>${percent(progress)}</small>`}</td>
    <td class="number">${count(cases.total)}${cases.failed > 0 && html` <small class="error">${count(cases.failed)} failed</small>`}</td>
    <td class="number">${took(study)}</td>
    <td class="number">${hasEnded(study) ? "" : duration(remaining.get(id))}</td>
    <td class="number">${instant(study.created_at)}</td>
    <td class="number"><span class="actions">${actions(study)}</span></td></tr>`;
};

const empty = () => {
  const { name, state } = filters();
  if (name || state) return html`<p class="empty">No study of this service is like that.</p>`;
  return html`<p class="empty">There is no study yet. <a href="${address("/studies/new")}">Begin with one</a>, maybe from a preset.</p>`;
};

render("studies", ({ items, next_cursor: more }) => {
  showRequests($("request"), [{ operation: "studies.list_studies", path: "/v1/studies", query: filters() }]);
  $("list").setAttribute("aria-busy", "false");
  forecast(items.filter((study) => !hasEnded(study)));
  if (!items.length) return empty();
  return html`<table class="studies"><caption class="hidden">Studies</caption>
    <thead><tr><th scope="col"><span class="hidden">Compare</span></th><th scope="col">Name</th><th scope="col">State</th><th scope="col">Progress</th>
      <th scope="col" class="number">Cases</th><th scope="col" class="number">Took</th><th scope="col" class="number">To go</th>
      <th scope="col" class="number">Created</th><th scope="col"><span class="hidden">Actions</span></th></tr></thead>
    <tbody>${items.map(row)}</tbody></table>
    ${more && html`<p class="empty"><button type="button" id="more">Show more</button></p>`}`;
});

// The list says how far studies are; when each will be finished, only the study itself.
const forecast = (studies) => {
  for (const { id } of studies.slice(0, 10)) {
    get(`/v1/studies/${id}`).then(
      ({ finish }) => remaining.set(id, finish && (new Date(finish.expected) - Date.now()) / 1000),
      () => remaining.delete(id),
    );
  }
};

$("list").addEventListener("change", ({ target }) => {
  if (target.checked) chosen.add(target.dataset.choose);
  else chosen.delete(target.dataset.choose);
  $("compare").href = address("/compare", { study: [...chosen] });
  $("compare").textContent = chosen.size ? `Compare ${chosen.size}` : "Compare";
});

$("list").addEventListener("click", async ({ target }) => {
  if (target.id !== "more") return;
  const { max_page_size: most } = await getOnce("/v1/limits");
  $("page_size").value = Math.min(most, 2 * $("page_size").value);
  $("filters").dispatchEvent(new Event("input", { bubbles: true }));
});
