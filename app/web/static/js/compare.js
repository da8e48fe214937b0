// Studies over one another: what they have in common along an axis, grouped by study and by the rest.

import { get, getOnce } from "./api.js";
import { count, digits, given, shownUnit, words } from "./format.js";
import { $, html, show } from "./html.js";
import { notify } from "./page.js";
import { Panel } from "./panel.js";
import { showRequests } from "./request.js";
import { heading } from "./sweep.js";
import { Table } from "./table.js";

const WAIT_MS = 200;
const chosen = new Set(new URLSearchParams(location.search).getAll("study"));
const names = new Map();
const table = new Table($("table"), "Numbers by study");
let panel;

const list = async () => {
  const { items } = await get("/v1/studies", { name: $("find").value, page_size: 30 });
  for (const id of chosen) if (!items.some((study) => study.id === id)) items.unshift(await get(`/v1/studies/${id}`));
  for (const { id, name } of items) names.set(id, name);
  const focused = document.activeElement?.id;
  show($("studies"), items.map(({ id, name, state, cases }) => html`<label class="choice"><input type="checkbox" id="study-${id}" value="${id}" ${chosen.has(id) ? "checked" : ""}>
    <span>${name}</span> <small><span class="state ${state}">${words(state)}</span> · ${count(cases.succeeded)} cases</small></label>`));
  if (!items.length) show($("studies"), html`<p class="empty">There is no such study.</p>`);
  if (focused) $(focused)?.focus();
};

// What does not vary in a study is the same in all its cases: taken from the first.
const conditionsOf = async (id) => {
  const { items: [first] } = await get(`/v1/studies/${id}/cases`, { page_size: 1 });
  const { speed_kmh, slab, percentile, wavelength_m, amplitude_mm } = first;
  return Object.fromEntries(Object.entries({ speed_kmh, slab, percentile, wavelength_m, amplitude_mm }).filter(([, value]) => value !== null));
};

const label = (id) => ([...chosen].filter((other) => names.get(other) === names.get(id)).length > 1 ? `${names.get(id)} (${id.slice(0, 6)})` : names.get(id));

const summaries = async (id) => {
  const [{ conditions }, fixed] = await Promise.all([get(`/v1/studies/${id}/statistics`, { statistic: $("statistic").value }), conditionsOf(id)]);
  return conditions.map((each) => ({ ...each, conditions: { study: label(id), ...fixed, ...each.conditions } }));
};

const results = async () => {
  const enough = chosen.size > 1;
  const found = enough && (await Promise.all([...chosen].map(summaries))).flat(); // before anything moves
  $("nothing").hidden = enough;
  $("results").hidden = !enough;
  if (enough) {
    panel.show(found);
    rows();
  }
  requests();
};

const rows = () => {
  const { quantity, position } = panel.choice;
  const own = panel.summaries.filter((each) => each.quantity === quantity && each.position === position);
  const { name: unit, factor } = shownUnit(panel.info.unit);
  const number = (key, pick) => ({ key, label: key, unit, number: true, value: pick, text: (row) => digits(factor * pick(row)) });
  table.show([
    ...[...panel.axes.keys()].map((name) => ({ key: name, label: heading(name).split(", ")[0], unit: heading(name).split(", ")[1], value: (row) => row.conditions[name], text: (row) => given(row.conditions[name]), number: typeof panel.axes.get(name)[0] === "number" })),
    number("median", (row) => row.quantiles.p50), number("mean", (row) => row.mean), number("minimum", (row) => row.minimum), number("maximum", (row) => row.maximum),
    { key: "count", label: "cases", number: true, value: (row) => row.count, text: (row) => count(row.count) },
  ], own);
  $("table-title").textContent = `${count(own.length)} conditions`;
};

const requests = () => {
  const { statistic } = panel.choice;
  showRequests($("request"), [...chosen].map((study_id) => ({ operation: "analysis.summarise_study", path: "/v1/studies/{study_id}/statistics", parameters: { study_id }, query: { statistic } })));
};

$("studies").addEventListener("change", ({ target }) => {
  if (target.checked) chosen.add(target.value);
  else chosen.delete(target.value);
  const address = new URL(location.href);
  address.searchParams.delete("study");
  for (const id of chosen) address.searchParams.append("study", id);
  history.replaceState(null, "", address);
  results().catch(notify);
});

let waiting;
$("find").addEventListener("input", () => {
  clearTimeout(waiting);
  waiting = setTimeout(() => list().catch(notify), WAIT_MS);
});

const begin = async () => {
  const [quantities] = await Promise.all([getOnce("/v1/quantities"), list()]);
  panel = new Panel(quantities.items, (name) => (name === "statistic" ? results().catch(notify) : (rows(), requests())));
  await results();
};
begin().catch(notify);
