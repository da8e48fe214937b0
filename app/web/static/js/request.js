// "The request that made this": what a view asked the API, as curl and as Python, to be copied.

import { address } from "./api.js";
import { html, renew, show } from "./html.js";

const quoted = (text) => `'${text.replaceAll("'", `'\\''`)}'`;

/** A JSON value as Python has it. */
export const python = (value, indent = "") => {
  const deeper = `${indent}    `;
  const block = (open, parts, close) => {
    const line = `${open}${parts.join(", ")}${close}`;
    return line.length < 90 && !line.includes("\n") ? line : `${open}\n${parts.map((part) => `${deeper}${part},\n`).join("")}${indent}${close}`;
  };
  if (value === null || value === undefined) return "None";
  if (value === true || value === false) return value ? "True" : "False";
  if (Array.isArray(value)) return block("[", value.map((each) => python(each, deeper)), "]");
  if (typeof value !== "object") return JSON.stringify(value);
  return block("{", Object.entries(value).map(([key, each]) => `${JSON.stringify(key)}: ${python(each, deeper)}`), "}");
};

const url = ({ path, parameters = {}, query }) =>
  String(address(path.replace(/\{(\w+)\}/g, (_, name) => encodeURIComponent(parameters[name])), query));

const asCurl = (asked) => {
  const { method = "GET", body, headers = {} } = asked;
  const all = { ...(sessionStorage.getItem("key") && { Authorization: "Bearer $TRACKSWEEP_API_KEY" }), ...(body && { "Content-Type": "application/json" }), ...headers };
  const parts = ["curl", ...(method === "GET" ? [] : [`-X ${method}`]), quoted(url(asked))];
  for (const [name, value] of Object.entries(all)) parts.push(`-H "${name}: ${value}"`);
  if (body) parts.push(`-d ${quoted(JSON.stringify(body, null, 1))}`);
  return parts.join(" \\\n  ");
};

const asPython = (asked) => {
  if (asked.python) return asked.python(service());
  const { operation, parameters = {}, query = {}, body, model } = asked;
  const [tag, name] = operation.split(".");
  const said = Object.entries({ ...parameters, ...query }).filter(([, value]) => value !== undefined && value !== null && value !== "");
  const given = said.map(([key, value]) => `${key}=${python(value)}`);
  if (body) given.push(`body=${model}.from_dict(${python(body, "    ")})`);
  return `from tracksweep_client import connect
from tracksweep_client.generated.api.${tag} import ${name}
${model ? `from tracksweep_client.generated.models import ${model}\n` : ""}
with connect(${python(service())}) as client:
    answer = ${name}.sync(${[...given, "client=client"].join(", ")})`;
};

const service = () => String(address("/")).replace(/\/$/, "");

/**
 * Show requests in a <details class="request">. Each is {operation: "studies.list_studies", path: "/v1/studies/{study_id}",
 * parameters, query, method, body, model: the name of the client's class for the body, python: (url) => text instead}.
 */
export const showRequests = (element, requests) => {
  if (element.contains(document.activeElement) && document.activeElement.localName === "button") return;
  if (!element.firstChild) show(element, html`<summary>The request behind this</summary><div></div>`);
  renew(element.lastChild, requests.map((asked) => html`<div class="asked">
    <h3>${asked.operation.split(".")[1]}</h3>
    ${code("curl", asCurl(asked))}${code("Python", asPython(asked))}</div>`));
  element.hidden = false;
};

const code = (name, text) => html`<figure><figcaption>${name} <button type="button" data-copy>Copy</button></figcaption><pre tabindex="0">${text}</pre></figure>`;

document.addEventListener("click", async ({ target }) => {
  if (!target.matches("[data-copy]")) return;
  await navigator.clipboard.writeText(target.closest("figure").querySelector("pre").textContent);
  target.textContent = "Copied";
  setTimeout(() => (target.textContent = "Copy"), 1500);
});
