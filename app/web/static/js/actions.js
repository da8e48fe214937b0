// What can be done with a study, by its state. htmx sends it, and page.js asks before.

import { address } from "./api.js";
import { html } from "./html.js";

const ENDED = ["succeeded", "partially_failed", "failed", "cancelled"];

export const hasEnded = (study) => ENDED.includes(study.state);

export const studyUrl = (id) => address(`/studies/${id}`);

/** Buttons for a study. */
export const actions = ({ id, name, state, cases }) => {
  const path = address(`/v1/studies/${id}`);
  const left = cases.queued + cases.running;
  const cancel = html`<button type="button" id="cancel-${id}" hx-post="${path}/cancel" hx-swap="none" data-done="“${name}” is cancelled."
    hx-confirm="What was computed stays; ${left} of ${cases.total} cases are called off, unless another study wants them."
    data-title="Cancel “${name}”?" data-action="Cancel the study">Cancel</button>`;
  const retry = html`<button type="button" id="retry-${id}" hx-post="${path}/retry" hx-swap="none"
    data-done="${cases.failed + cases.cancelled} cases are queued once more.">Retry</button>`;
  const remove = html`<button type="button" id="delete-${id}" hx-delete="${path}" hx-swap="none" data-done="“${name}” is deleted."
    hx-confirm="Its histories that no other study keeps are deleted with it. Peaks stay, so that no case is computed twice."
    data-title="Delete “${name}”?" data-action="Delete the study">Delete</button>`;
  const again = cases.failed + cases.cancelled > 0;
  if (!ENDED.includes(state)) return [state !== "cancelling" && cancel];
  return [again && retry, remove];
};
