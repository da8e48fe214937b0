// The reader's API key: asked for when the service wants one, kept in this tab only.

import { $ } from "./html.js";

let asking = null;

/** Ask for a key, once however many requests want it. Resolves to whether there is a new one. */
export const askForKey = (why) => {
  asking ??= ask(why).finally(() => (asking = null));
  return asking;
};

const ask = (why) => {
  const dialog = $("key-dialog");
  $("key-why").textContent = why;
  $("key").value = "";
  dialog.returnValue = "cancel";
  dialog.showModal();
  return new Promise((resolve) => {
    const closed = () => {
      const given = dialog.returnValue === "use";
      if (given) sessionStorage.setItem("key", $("key").value.trim());
      tellOfKey();
      resolve(given);
    };
    dialog.addEventListener("close", closed, { once: true });
  });
};

/** Show whether there is a key to be forgotten. */
export const tellOfKey = () => {
  $("key-button").hidden = !sessionStorage.getItem("key");
};
