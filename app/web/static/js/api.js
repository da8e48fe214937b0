// The API: requests with the reader's key, and its problems as errors.

import { askForKey } from "./key.js";

const ROOT = new URL(document.documentElement.dataset.root, location.href);
const PAUSES_S = [1, 2, 5, 10, 30];

/** The service's answer when it cannot do what was asked; `errors` name the fields. */
export class Problem extends Error {
  constructor(status, details) {
    super(details.detail);
    Object.assign(this, { status, code: details.code, errors: details.errors ?? [] });
  }
}

/** The absolute URL of a path such as "/v1/studies"; of what a query leaves empty nothing is said. */
export const address = (path, query = {}) => {
  const url = new URL(path.replace(/^\//, ""), ROOT);
  for (const [name, value] of Object.entries(query)) {
    for (const each of [value].flat()) {
      if (each !== undefined && each !== null && each !== "") url.searchParams.append(name, each);
    }
  }
  return url;
};

/** The answer to what was asked before this module was there (see ahead.js), once. */
const ahead = (url) => {
  const answer = window.ahead.get(String(url));
  window.ahead.delete(String(url));
  return answer;
};

/** fetch() with the key; asks for one where it is needed. */
export const send = async (url, options = {}) => {
  const reads = (options.method ?? "GET") === "GET";
  for (let why = null; ; ) {
    const key = sessionStorage.getItem("key");
    const headers = new Headers(options.headers);
    if (key) headers.set("Authorization", `Bearer ${key}`);
    const response = (reads && (await ahead(url))) || (await fetch(url, { ...options, headers }));
    if (response.status !== 401) return response;
    why = (await response.clone().json()).detail;
    if (key === sessionStorage.getItem("key") && !(await askForKey(why))) return response;
  }
};

/** What a response that is no success says. */
export const problemOf = async (response) => {
  const details = await response.json().catch(() => ({ detail: `The service answered ${response.status}.` }));
  return new Problem(response.status, details);
};

/**
 * One request: request("POST", "/v1/studies", {body, headers, signal}). Resolves to the answer's JSON, null if there is
 * none; rejects with a Problem.
 */
export const request = async (method, path, { query, body, headers = {}, signal } = {}) => {
  const json = body === undefined || typeof body === "string" || body instanceof Blob ? body : JSON.stringify(body);
  const type = json !== body ? { "Content-Type": "application/json" } : {};
  const response = await send(address(path, query), { method, body: json, headers: { ...type, ...headers }, signal });
  if (!response.ok) throw await problemOf(response);
  return response.status === 204 ? null : response.json();
};

export const get = (path, query, signal) => request("GET", path, { query, signal });

const kept = new Map();

/** The same, asked for once per page: for the catalogue. */
export const getOnce = (path) => {
  if (!kept.has(path)) kept.set(path, get(path));
  return kept.get(path);
};

/** All rows of a list, page by page; at most so many. */
export const all = async (path, query = {}, atMost = 50_000, signal = undefined) => {
  const page_size = (await getOnce("/v1/limits")).max_page_size;
  const items = [];
  let cursor = null;
  do {
    const page = await get(path, { ...query, page_size, cursor }, signal);
    items.push(...page.items);
    cursor = page.next_cursor;
  } while (cursor && items.length < atMost);
  return { items: items.slice(0, atMost), complete: !cursor };
};

/**
 * Follow a study to its end: `hear(event, data)` for every event of the stream, which goes on where it was cut. Not by
 * EventSource, as that can send no key.
 */
export const watch = async (studyId, hear, signal) => {
  let last = 0;
  for (let failures = 0; ; ) {
    try {
      const response = await send(address(`/v1/studies/${studyId}/events`, { last_event_id: last }), { signal });
      if (response.status === 204) return;
      if (!response.ok) throw await problemOf(response);
      for await (const { id, event, data } of events(response)) {
        failures = 0;
        last = id ?? last;
        hear(event, JSON.parse(data));
        if (event === "done") return;
      }
    } catch (error) {
      if (signal?.aborted) return;
      if (error instanceof Problem && ![429, 503].includes(error.status)) throw error;
    }
    const pause = PAUSES_S[Math.min(failures++, PAUSES_S.length - 1)];
    await new Promise((resolve) => setTimeout(resolve, 1000 * pause));
  }
};

async function* events(response) {
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  for (let text = ""; ; ) {
    const { value, done } = await reader.read();
    if (done) return;
    const blocks = (text + value).split("\n\n");
    text = blocks.pop();
    for (const block of blocks) {
      const fields = Object.fromEntries(
        block.split("\n").filter((line) => /^\w/.test(line)).map((line) => line.split(/: ?(.*)/s)),
      );
      if (fields.data !== undefined) yield fields;
    }
  }
}
