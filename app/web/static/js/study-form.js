// The form of a study: what it says as JSON, JSON as what it says, and problems at their fields.

import { given } from "./format.js";
import { $, html, show } from "./html.js";

const KINDS = ["none", "harmonic", "spectrum", "measured"];
const PARTS = ["track", "vehicle", "numerics"];

/** A number, or what was written instead: of that the API says what is wrong. */
const number = (text) => (text.trim() === "" || Number.isNaN(Number(text)) ? text.trim() : Number(text));
const single = (id) => ($(id).value.trim() === "" ? undefined : number($(id).value));
const list = (text) => text.split(/[\s,;]+/).filter(Boolean).map(number);
const bands = (text) =>
  list(text.replace(/\s*[–-]\s*/g, "–")).map((each) => {
    const ends = String(each).split("–");
    return ends.length === 2 ? { min: number(ends[0]), max: number(ends[1]) } : each;
  });
const plain = (value) => (Math.abs(value) >= 1e5 ? value.toExponential().replace("e+", "e") : String(value)); // as it can be read again
const written = (values) => (values ?? []).map((each) => (each?.min === undefined ? plain(each) : `${plain(each.min)}–${plain(each.max)}`)).join(", ");
const SUPERSCRIPTS = { "^2": "²", "^3": "³", "^4": "⁴", " s/": "·s/", "kg m": "kg·m" };
const unitOf = (unit) => unit.replace(/\^[234]| s\/|kg m/g, (found) => SUPERSCRIPTS[found]);
const short = (value) => (typeof value === "number" ? given(Number(value.toPrecision(6))) : value);
const checked = (name) => [...$("form").querySelectorAll(`[name="${name}"]:checked`)].map(({ value }) => value);
const escaped = (key) => key.replaceAll("~", "~0").replaceAll("/", "~1");

const irregularity = () => {
  const kind = $("kind").value;
  if (kind === "harmonic") return { kind, wavelength_m: list($("wavelength_m").value), amplitude_mm: list($("amplitude_mm").value) };
  if (kind === "spectrum") {
    return {
      kind, spectrum: $("spectrum").value, percentile: list($("percentile").value),
      wavelength_band_m: bands($("bands").value), realisations: single("realisations"), seed: single("seed"),
    };
  }
  const own = bands($("profile-bands").value);
  return kind === "measured" ? { kind, profile_id: $("profile").value, wavelength_band_m: own.length ? own : undefined } : { kind };
};

const speeds = () =>
  checked("speeds")[0] === "range"
    ? { kind: "range", start: single("start"), stop: single("stop"), step: single("step") }
    : list($("speed_kmh").value);

const labels = () => {
  const pairs = $("labels").value.split(",").filter((each) => each.trim()).map((each) => each.split(/=(.*)/s));
  return pairs.length ? Object.fromEntries(pairs.map(([key, value = ""]) => [key.trim(), value.trim()])) : undefined;
};

const varied = () => {
  const rows = [...$("vary").children].map((row) => [row.querySelector("[list]").value.trim(), list(row.querySelector("[data-pointer]").value)]);
  const named = rows.filter(([path]) => path);
  return named.length ? Object.fromEntries(named) : undefined;
};

const part = (name) => {
  const values = {};
  if (name !== "numerics") values.base = $(`${name}-base`).value;
  for (const field of $(`${name}-values`).querySelectorAll("[data-name]")) {
    if (!field.value.trim()) continue;
    const [outer, inner] = field.dataset.name.split(".");
    if (inner) (values[outer] ??= {})[inner] = number(field.value);
    else values[outer] = number(field.value);
  }
  return Object.keys(values).length ? values : undefined;
};

/** The study that the form says, as create_study takes it. */
export const study = () => {
  const said = {
    name: $("name").value, labels: labels(), priority: single("priority"), keep_history: $("keep_history").checked || undefined,
    sweep: { kind: "product", speed_kmh: speeds(), slab: checked("slab"), irregularity: irregularity(), vary: varied() },
    ...Object.fromEntries(PARTS.map((name) => [name, part(name)])),
  };
  return JSON.parse(JSON.stringify(said)); // without what is not said
};

/** Whether the form has fields for all that a study says. */
export const fits = ({ sweep }) => {
  const rail = sweep?.irregularity;
  return sweep?.kind === "product" && KINDS.includes(rail?.kind) && (rail.spectrum === undefined || typeof rail.spectrum === "string");
};

/** Let the form say a study. */
export const fill = (study, catalogue) => {
  const { speed_kmh, slab = ["continuous"], irregularity: rail, vary = {} } = study.sweep;
  const set = (id, value) => ($(id).value = value ?? "");
  set("name", study.name);
  set("labels", Object.entries(study.labels ?? {}).map((pair) => pair.join("=")).join(", "));
  set("priority", study.priority || "");
  $("keep_history").checked = study.keep_history ?? false;
  const range = Array.isArray(speed_kmh) ? {} : speed_kmh;
  for (const each of $("form").elements.speeds) each.checked = (each.value === "range") === Boolean(range.kind);
  set("speed_kmh", Array.isArray(speed_kmh) ? written(speed_kmh) : "");
  for (const id of ["start", "stop", "step"]) set(id, range[id]);
  for (const each of $("form").elements.slab) each.checked = slab.includes(each.value);
  set("kind", rail.kind);
  for (const id of ["wavelength_m", "amplitude_mm", "percentile"]) set(id, written(rail[id]));
  set("spectrum", rail.spectrum ?? catalogue.spectra[0].name);
  set(rail.kind === "measured" ? "profile-bands" : "bands", written(rail.wavelength_band_m));
  if (rail.profile_id) set("profile", rail.profile_id);
  if (rail.kind === "spectrum" && !rail.percentile) set("percentile", "63.2");
  for (const id of ["realisations", "seed"]) set(id, rail[id] ?? (rail.kind === "spectrum" ? 1 : ""));
  $("vary").replaceChildren();
  for (const [path, values] of Object.entries(vary)) addVaried(catalogue, path, written(values));
  for (const name of PARTS) {
    const own = study[name] ?? {};
    if (name !== "numerics") set(`${name}-base`, own.base ?? catalogue[name][0].name);
    fillPart(name, catalogue);
    for (const field of $(`${name}-values`).querySelectorAll("[data-name]")) {
      field.value = field.dataset.name.split(".").reduce((node, key) => node?.[key], own) ?? "";
    }
  }
  adapt();
};

/** Show the fields of what is chosen, and say which values are not the catalogue's. */
export const adapt = () => {
  const chosen = { kind: $("kind").value, speeds: checked("speeds")[0] };
  for (const each of $("form").querySelectorAll("[data-when]")) {
    const [name, value] = each.dataset.when.split("=");
    each.hidden = chosen[name] !== value;
  }
  for (const name of PARTS) {
    const fields = [...$(`${name}-values`).querySelectorAll("[data-name]")];
    for (const field of fields) field.closest("tr").classList.toggle("changed", field.value.trim() !== "");
    const changed = fields.filter((field) => field.value.trim()).map((field) => `${field.dataset.name} = ${field.value}`);
    $(`${name}-values`).querySelector("summary").textContent = `${fields.length} values${changed.length ? `, ${changed.length} changed: ${changed.join(", ")}` : ", each with its source"}`;
  }
};

/** The values of a track, a vehicle or the numerics, each to be changed. */
export const fillPart = (name, catalogue) => {
  const rows = name === "numerics" ? catalogue.numerics : catalogue[name].find((set) => set.name === $(`${name}-base`).value).values;
  const control = ({ name: key, value }) => {
    const id = `${name}.${key}`;
    const pointer = `/${name}/${key.replace(".", "/")}`;
    if (key !== "wheel_tread") return html`<input id="${id}" data-name="${key}" data-pointer="${pointer}" placeholder="${short(value)}" autocomplete="off" inputmode="decimal">`;
    return html`<select id="${id}" data-name="${key}" data-pointer="${pointer}"><option value="">${value}</option>${catalogue.treads.map((tread) => html`<option value="${tread.name}">${tread.name}</option>`)}</select>`;
  };
  const row = (each) => html`<tr><td><label for="${name}.${each.name}">${each.meaning}</label></td><td>${control(each)}</td><td class="unit">${unitOf(each.unit)}</td><td class="source">${each.told}</td></tr>`;
  show($(`${name}-values`).querySelector("table"), html`<thead><tr><th scope="col">Value</th><th scope="col">instead of</th><th scope="col">Unit</th><th scope="col">${name === "numerics" ? "Bounds" : "Of what, and source"}</th></tr></thead><tbody>${rows.map(row)}</tbody>`);
};

/** One more parameter to vary. */
export const addVaried = (catalogue, path = "", values = "") => {
  const row = document.createElement("div");
  row.className = "vary";
  show(row, html`<input list="paths" aria-label="Parameter" placeholder="track.pad_stiffness_n_per_m" value="${path}" spellcheck="false">
    <input aria-label="Values" placeholder="4e7, 6e7" value="${values}" data-pointer="" autocomplete="off">
    <button type="button" aria-label="Remove this parameter">×</button><small></small>`);
  const [name, , remove] = row.children;
  const tell = () => {
    const known = catalogue.parameters.get(name.value.trim());
    row.querySelector("[data-pointer]").dataset.pointer = `/sweep/vary/${escaped(name.value.trim())}`;
    row.querySelector("small").textContent = known ? `${known.meaning}${known.unit && `, ${unitOf(known.unit)}`}; ${known.bounds}` : "";
  };
  name.addEventListener("input", tell);
  remove.addEventListener("click", () => {
    row.remove();
    $("form").dispatchEvent(new Event("input", { bubbles: true }));
  });
  tell();
  $("vary").append(row);
  return row;
};

/** Put each error at its field, in the API's words; returns those that no field is to blame for. */
export const tellErrors = (errors) => {
  for (const old of $("form").querySelectorAll(".error[data-of]")) old.remove();
  for (const field of $("form").querySelectorAll("[data-pointer]")) {
    field.removeAttribute("aria-invalid");
    describe(field, field.getAttribute("aria-describedby")?.split(" ").filter((id) => !id.startsWith("error-")) ?? []);
  }
  const fields = [...$("form").querySelectorAll("[data-pointer]")].filter((field) => !field.closest("[hidden]"));
  return errors.filter((error, n) => {
    const within = fields.filter(({ dataset: { pointer } }) => pointer === error.pointer || error.pointer.startsWith(`${pointer}/`));
    const field = within.toSorted((a, b) => b.dataset.pointer.length - a.dataset.pointer.length)[0];
    if (field) tellAt(field, error, `error-${n}`);
    return !field;
  });
};

const tellAt = (field, { pointer, detail }, id) => {
  const message = document.createElement("p");
  const rest = pointer.slice(field.dataset.pointer.length + 1).split("/")[0];
  const nth = /^\d+$/.test(rest) && field.dataset.pointer !== "/line" && field.localName === "input";
  Object.assign(message, { id, className: "error", textContent: nth ? `Value ${Number(rest) + 1}: ${detail}` : detail });
  message.dataset.of = field.dataset.pointer;
  if (field.matches("input, select, textarea")) {
    field.setAttribute("aria-invalid", "true");
    (field.closest(".vary, td, .field") ?? field.parentElement).append(message);
  } else field.append(message);
  describe(field, [...(field.getAttribute("aria-describedby")?.split(" ") ?? []), id]);
};

const describe = (field, ids) => {
  if (ids.length) field.setAttribute("aria-describedby", ids.join(" "));
  else field.removeAttribute("aria-describedby");
};
