// New study: fill the form, tell what it would take, create it.

import { address, all, get, getOnce, Problem, request } from "./api.js";
import { count, digits, duration, given, instant } from "./format.js";
import { $, html, ready, show } from "./html.js";
import { notify } from "./page.js";
import { preview } from "./preview.js";
import { python, showRequests } from "./request.js";
import { adapt, addVaried, fill, fits, study, tellErrors } from "./study-form.js";

const PAUSE_MS = 300;
const FIRST = "speed-sweep";
const MARKS = { V: "read in the source", C: "in common use, primary source not seen", A: "assumed here" };
const JSON_TYPE = { "Content-Type": "application/json" };

const [timer, sent] = [{}, { body: "", key: "" }];
let [asked, catalogue, profiles] = [null, null, []];

const load = async () => {
  const paths = ["/v1/limits", "/v1/tracks", "/v1/vehicles", "/v1/spectra", "/v1/presets"];
  const [limits, tracks, vehicles, spectra, presets] = await Promise.all(paths.map(getOnce));
  const told = (each) => `${each.basis}; ${each.source} (${MARKS[each.mark]})`;
  const sets = ({ items }) => items.map((set) => ({ ...set, values: set.values.map((each) => ({ ...each, told: told(each) })) }));
  const numerics = limits.parameters.filter(({ path }) => path.startsWith("numerics."));
  catalogue = {
    track: sets(tracks), vehicle: sets(vehicles), treads: vehicles.wheel_treads, spectra: spectra.items, presets: presets.items,
    parameters: new Map(limits.parameters.map((each) => [each.path, { ...each, bounds: bounds(each) }])),
    numerics: numerics.map((each) => ({ ...each, name: each.path.replace("numerics.", ""), value: each.default, told: bounds(each) })),
  };
  const options = (items) => html`${items.map(({ name, title }) => html`<option value="${name}">${title}</option>`)}`;
  for (const name of ["track", "vehicle"]) show($(`${name}-base`), options(catalogue[name]));
  show($("spectrum"), options(catalogue.spectra));
  show($("preset"), html`<option value="">…</option>${options(catalogue.presets)}`);
  show($("paths"), html`${limits.parameters.map(({ path, meaning }) => html`<option value="${path}">${meaning}</option>`)}`);
  await loadProfiles();
};

const bounds = ({ minimum, exclusive_minimum, maximum, exclusive_maximum }) =>
  [
    exclusive_minimum !== null && `above ${given(exclusive_minimum)}`, minimum !== null && `at least ${given(minimum)}`,
    exclusive_maximum !== null && `below ${given(exclusive_maximum)}`, maximum !== null && `at most ${given(maximum)}`,
  ].filter(Boolean).join(", ");

const loadProfiles = async (chosen = $("profile").value) => {
  profiles = (await all("/v1/profiles", {}, 500)).items;
  const name = (each) => `${each.id.slice(0, 8)}: ${given(each.start_m)} to ${given(each.end_m)} m, ${count(each.points)} points, ${instant(each.created_at)}`;
  show($("profile"), html`${profiles.length ? "" : html`<option value="">none is stored yet</option>`}${profiles.map((each) => html`<option value="${each.id}">${name(each)}</option>`)}`);
  if (chosen) $("profile").value = chosen;
};

/** What would be sent now: the study, or the text of whoever writes JSON. */
const body = () => ($("json-mode").checked ? $("json").value : JSON.stringify(study(), null, 1));

const parsed = () => {
  try {
    return JSON.parse(body());
  } catch {
    return null;
  }
};

const changed = () => {
  adapt();
  const now = parsed();
  hints();
  preview($("json-mode").checked ? null : now.sweep.irregularity, profiles);
  if (now) showRequests($("request"), [asRequest(now)]);
  $("estimate").classList.add("stale");
  clearTimeout(timer.id);
  timer.id = setTimeout(estimate, PAUSE_MS);
};

const asRequest = (now) => ({
  operation: "studies.create_study", method: "POST", path: "/v1/studies", body: now,
  python: (url) => `from tracksweep_client import Service\n\nwith Service(${JSON.stringify(url)}) as service:\n    study = service.submit(${python(now, "    ")})\n    service.wait(study.id)  # shows a progress bar\n    peaks = service.to_dataframe(study_id=study.id)`,
});

const hints = () => {
  const range = (span, unit) => (span ? ` ${given(span.min)} to ${given(span.max)} ${unit}` : "");
  const spectrum = catalogue.spectra.find(({ name }) => name === $("spectrum").value);
  const [scope, source] = [[range(spectrum.wavelength_range_m, "m"), range(spectrum.speed_range_kmh, "km/h")].filter(Boolean), spectrum.sources[0]];
  $("spectrum-hint").textContent = `${scope.length ? `Drawn up for${scope.join(",")}. ` : ""}${source.source} (${MARKS[source.mark]}).`;
  const profile = profiles.find(({ id }) => id === $("profile").value);
  $("profile-hint").textContent = profile ? `Heights ${digits(profile.lowest_mm, 3)} to ${digits(profile.highest_mm, 3)} mm; holds waves of ${range({ min: profile.wavelength_min_m, max: profile.wavelength_max_m }, "m")}.` : "";
  $("about").textContent = catalogue.presets.find(({ name }) => name === $("preset").value)?.description ?? "";
};

const estimate = async () => {
  asked?.abort();
  asked = new AbortController();
  try {
    const found = await request("POST", "/v1/study-estimates", { body: body(), headers: JSON_TYPE, signal: asked.signal });
    $("refused").textContent = "";
    tellErrors([]);
    show($("estimate"), estimated(found));
  } catch (error) {
    if (error.name === "AbortError") return;
    refuse(error);
    show($("estimate"), html`<p class="hint">An estimate is made once the study is valid.</p>`);
  }
  $("estimate").classList.remove("stale");
};

const estimated = ({ cases, cpu, finish, workers, queue_cpu_s, warnings }) => html`<dl class="facts">
  <div><dt>Cases</dt><dd>${count(cases.total)}</dd></div><div><dt>to compute</dt><dd>${count(cases.new)}</dd></div>
  <div><dt>stored</dt><dd>${count(cases.computed)}</dd></div><div><dt>in flight</dt><dd>${count(cases.in_flight)}</dd></div>
  ${cases.failed > 0 && html`<div><dt>failed before</dt><dd>${count(cases.failed)}</dd></div>`}
  <div><dt>Processor time</dt><dd>${cases.new ? duration(cpu.expected_s) : "none"}</dd>${cases.new > 0 && html`<small>${cpu.basis === "same-operator" ? `${duration(cpu.least_s)} to ${duration(cpu.most_s)}` : "a guess: nothing like it was computed here yet"}</small>`}</div>
  <div><dt>Done</dt><dd>${finish ? instant(finish.expected) : workers || !(cases.new + cases.in_flight) ? "at once" : "no worker"}</dd><small>${workers} ${workers === 1 ? "worker" : "workers"}${queue_cpu_s >= 1 && `, ${duration(queue_cpu_s)} before it`}</small></div>
</dl>${warnings.length > 0 && html`<ul aria-label="Beware">${warnings.map(({ detail, pointer }) => html`<li>${detail}<code>${pointer}</code></li>`)}</ul>`}`;

/** What the API refuses, at the fields; what no field is to blame for, beside the button. */
const refuse = (error) => {
  if (!(error instanceof Problem)) return notify(error);
  const rest = tellErrors(error.errors);
  const told = error.errors.length && !rest.length ? `${error.errors.length === 1 ? "One field is" : `${error.errors.length} fields are`} not valid.` : error.message;
  $("refused").textContent = [told, ...rest.map(({ pointer, detail }) => `${pointer}: ${detail}`)].join(" ");
};

const create = async (event) => {
  event.preventDefault();
  clearTimeout(timer.id);
  if (body() !== sent.body) Object.assign(sent, { body: body(), key: [...crypto.getRandomValues(new Uint32Array(4))].join("-") });
  $("create").disabled = true;
  try {
    const { id } = await request("POST", "/v1/studies", { body: sent.body, headers: { ...JSON_TYPE, "Idempotency-Key": `"${sent.key}"` } });
    location.href = address(`/studies/${id}`);
  } catch (error) {
    refuse(error);
    const field = $("form").querySelector("[aria-invalid=true]");
    for (let node = field?.closest("details"); node; node = node.parentElement.closest("details")) node.open = true;
    field?.focus();
    $("create").disabled = false;
  }
};

const upload = async () => {
  const [file] = $("file").files;
  if (!file) return;
  try {
    const stored = await request("POST", "/v1/profiles", { body: file, headers: { "Content-Type": "text/csv" } });
    await loadProfiles(stored.id);
    changed();
  } catch (error) {
    refuse(error);
  }
  $("file").value = "";
};

const begin = (from) => {
  $("json-mode").checked = !fits(from);
  if (fits(from)) fill(from, catalogue);
  else $("json").value = JSON.stringify(from, null, 1);
  swap();
};

const swap = () => {
  const own = $("json-mode").checked;
  $("parts").hidden = own;
  $("as-json").hidden = !own;
  changed();
};

const start = async () => {
  await load();
  $("preset").addEventListener("change", () => {
    const preset = catalogue.presets.find(({ name }) => name === $("preset").value);
    if (preset) begin(preset.study);
  });
  $("form").addEventListener("input", ({ target }) => target.type !== "file" && target.id !== "shown" && changed());
  for (const name of ["track", "vehicle"]) $(`${name}-base`).addEventListener("change", () => begin(study()));
  $("add").addEventListener("click", () => addVaried(catalogue).firstElementChild.focus());
  $("file").addEventListener("change", upload);
  $("form").addEventListener("submit", create);
  $("json-mode").addEventListener("change", () => {
    if ($("json-mode").checked) $("json").value = JSON.stringify(study(), null, 1);
    else if (parsed() && fits(parsed())) fill(parsed(), catalogue);
    else $("json-mode").checked = true;
    swap();
  });
  const like = new URLSearchParams(location.search).get("like");
  if (!like) $("preset").value = FIRST;
  begin(like ? (await get(`/v1/studies/${like}`)).definition : catalogue.presets.find(({ name }) => name === FIRST).study);
};

start().catch(notify).finally(ready);
