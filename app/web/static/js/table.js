// Tables that are sorted by a click on a heading.

import { html, show } from "./html.js";

const AT_ONCE = 500;

/**
 * A table of rows: columns are {key, label, unit, value: (row) => what to sort by, text: (row) => what to show,
 * number: true}. It keeps its order when it is given other rows.
 */
export class Table {
  constructor(element, caption) {
    Object.assign(this, { element, caption, rows: [], columns: [], sort: null, down: false, shown: AT_ONCE });
    element.addEventListener("click", ({ target }) => {
      const heading = target.closest("[data-sort]");
      if (heading) this.order(heading.dataset.sort);
      if (target.closest("[data-more]")) {
        this.shown += AT_ONCE;
        this.draw();
      }
    });
  }

  show(columns, rows) {
    Object.assign(this, { columns, rows });
    this.draw();
  }

  order(key) {
    this.down = this.sort === key && !this.down;
    this.sort = key;
    this.draw();
    this.element.querySelector(`[data-sort="${CSS.escape(key)}"]`).focus();
  }

  sorted() {
    const column = this.columns.find(({ key }) => key === this.sort);
    if (!column) return this.rows;
    const sign = this.down ? -1 : 1;
    const missing = (value) => value === null || value === undefined;
    return this.rows.toSorted((a, b) => {
      const [left, right] = [column.value(a), column.value(b)];
      if (missing(left) || missing(right)) return missing(left) - missing(right);
      return sign * (typeof left === "number" && typeof right === "number" ? left - right : String(left).localeCompare(String(right)));
    });
  }

  draw() {
    const rows = this.sorted();
    const heading = ({ key, label, unit, number }) => {
      const direction = key === this.sort ? (this.down ? "descending" : "ascending") : "none";
      return html`<th scope="col" aria-sort="${direction}" class="${number && "number"}"><button type="button" data-sort="${key}">${label}${unit && html`<small>${unit}</small>`}</button></th>`;
    };
    show(this.element, html`<table><caption class="hidden">${this.caption}</caption>
      <thead><tr>${this.columns.map(heading)}</tr></thead>
      <tbody>${rows.slice(0, this.shown).map((row) => html`<tr>${this.columns.map((column) => html`<td class="${column.number && "number"}">${column.text(row)}</td>`)}</tr>`)}</tbody></table>
      ${rows.length > this.shown && html`<button type="button" data-more>Show more of ${rows.length} rows</button>`}`);
  }
}
