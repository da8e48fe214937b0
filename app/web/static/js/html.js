// HTML in template literals: html`<b>${text}</b>` escapes what it is given, unless that was made the same way.

const ESCAPES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };

class Html extends String {}

const written = (value) => {
  if (value === null || value === undefined || value === false) return "";
  if (Array.isArray(value)) return value.map(written).join("");
  return value instanceof Html ? String(value) : String(value).replace(/[&<>"']/g, (found) => ESCAPES[found]);
};

export const html = (strings, ...values) => new Html(String.raw({ raw: strings }, ...values.map(written)));

/** Put made HTML into an element. */
export const show = (element, made) => {
  element.innerHTML = written(made);
};

const shown = new WeakMap(); // what was put into elements by renew()

/** As show(), but what is the same stays, under a click or a selection. */
export const renew = (element, made) => {
  const text = written(made);
  if (shown.get(element) !== text) element.innerHTML = text;
  shown.set(element, text);
};

/** The element of an id. */
export const $ = (id) => document.getElementById(id);

/** Show what was held back until its first data were there. */
export const ready = () => $("main").classList.remove("waiting");

const whenIdle = window.requestIdleCallback ?? setTimeout; // Safari has none

/** Resolves when nothing else is to be done. */
export const idle = () => new Promise((resolve) => whenIdle(resolve));

/** A function that draws the first of many things at once and the others when nothing else is to be done, until other
 * things are to be drawn.
 */
export const inTurns = (draw) => {
  let now;
  return async ([first, ...others]) => {
    const mine = (now = {});
    if (first) draw(first);
    for (const thing of others) {
      await idle();
      if (now !== mine) return;
      draw(thing);
    }
  };
};
