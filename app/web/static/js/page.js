// What every view has: the choice of colours, the key, confirmations, notices, and htmx over the JSON API.

import { Problem, problemOf, send } from "./api.js";
import { $, html, show } from "./html.js";
import { tellOfKey } from "./key.js";
import { save } from "./save.js";

const NOTICE_S = 12;

const theme = $("theme");
theme.value = document.documentElement.dataset.theme ?? "";
theme.addEventListener("change", () => {
  localStorage.setItem("theme", theme.value);
  if (theme.value) document.documentElement.dataset.theme = theme.value;
  else delete document.documentElement.dataset.theme;
  document.dispatchEvent(new Event("colours"));
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  document.dispatchEvent(new Event("colours"));
});

$("key-button").addEventListener("click", () => {
  sessionStorage.removeItem("key");
  location.reload();
});
tellOfKey();

/** Tell the reader something; of a Problem, which fields it concerns too. */
export const notify = (what, kind = what instanceof Error ? "error" : "done") => {
  const fields = what instanceof Problem ? what.errors : [];
  const text = String(what.message ?? what);
  if ([...$("notices").children].some((each) => each.dataset.text === text)) return;
  const notice = document.createElement("div");
  notice.dataset.text = text;
  notice.className = `notice ${kind}`;
  show(notice, html`<p>${text}</p>${fields.map((each) => html`<p><code>${each.pointer}</code> ${each.detail}</p>`)}
    <button type="button" aria-label="Close">×</button>`);
  const close = () => notice.remove();
  notice.querySelector("button").addEventListener("click", close);
  if (kind !== "error") setTimeout(close, 1000 * NOTICE_S);
  $("notices").append(notice);
};

/** Ask before something that cannot be undone. Resolves to whether to go on. */
export const confirm = (title, text, action) => {
  const dialog = $("confirm-dialog");
  $("confirm-title").textContent = title;
  $("confirm-text").textContent = text;
  $("confirm-go").textContent = action;
  dialog.returnValue = "cancel";
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => resolve(dialog.returnValue === "go"), { once: true });
  });
};

// htmx asks the API too, with the key. Elements with data-render show the JSON that comes through the function of that
// name; others only tell what went wrong, and raise "changed" on the document when nothing did.
const renderers = {};

/** Name a function that makes HTML of an answer: render("studies", (page) => html`…`). */
export const render = (name, make) => {
  renderers[name] = make;
};

document.addEventListener("htmx:config:request", ({ detail: { ctx } }) => {
  ctx.fetch = send;
  for (const [name, value] of [...(ctx.request.body ?? [])]) if (value === "") ctx.request.body.delete(name);
});

document.addEventListener("htmx:confirm", (event) => {
  event.preventDefault();
  const { title, action } = event.detail.ctx.sourceElement.dataset;
  confirm(title, event.detail.ctx.confirm, action).then((go) => {
    if (go) event.detail.issueRequest();
    else event.detail.dropRequest();
  });
});

document.addEventListener("htmx:after:request", ({ detail: { ctx } }) => {
  const { render: name, done } = ctx.sourceElement.dataset;
  if (ctx.response.status >= 400) {
    ctx.swap = "none";
    problemOf(new Response(ctx.text, { status: ctx.response.status })).then(notify);
  } else if (name) {
    ctx.text = String(renderers[name](JSON.parse(ctx.text)));
  } else {
    ctx.swap = "none";
    notify(done);
    document.dispatchEvent(new Event("changed"));
  }
});

document.addEventListener("htmx:error", ({ detail: { error } }) => {
  if (error?.name === "TypeError") notify(new Error("The service cannot be reached. It is asked again."), "error");
});

// Files, which a link can fetch only where no key is needed.
document.addEventListener("click", async (event) => {
  const link = event.target.closest("a[download]");
  if (!link || !sessionStorage.getItem("key") || link.protocol === "blob:") return;
  event.preventDefault();
  const response = await send(link.href);
  if (response.ok) save(await response.blob(), link.download);
  else notify(await problemOf(response));
});
