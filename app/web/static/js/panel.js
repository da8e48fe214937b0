// The choice of quantity, position, axis and statistic; the chart of what is chosen, and a small one of each quantity.

import { Chart } from "./chart.js";
import { quantity, shownUnit, words } from "./format.js";
import { $, html, inTurns, renew, show } from "./html.js";
import { notify } from "./page.js";
import { saveChart } from "./svg.js";
import { axesOf, curves, firstAxis, heading } from "./sweep.js";

const CHOICES = ["quantity", "position", "axis", "statistic"];
const SMALL_PX = 190; // how high small charts are
const BAND = "Lines: median of the realisations; bands, outlined where the line is dashed: from their 5th to their 95th percentile.";

const choose = (select, options, value) => {
  renew(select, options.map(([key, label]) => html`<option value="${key}">${label}</option>`));
  select.value = options.some(([key]) => key === value) ? value : options[0]?.[0] ?? "";
};

/** Room for a small chart. All get theirs at once, so that what is below them does not move while they are drawn. */
const sheet = ({ info, position }) => {
  const made = document.createElement("section");
  made.className = "sheet";
  const { name: unit } = shownUnit(info.unit);
  show(made, html`<h3 class="one-line"><button type="button" class="plain" data-quantity="${info.name}" title="${info.title}">${info.title}</button> <small>${unit}${info.positions.length > 1 && ` · ${words(position)}`}</small></h3><div id="small-${info.name}"></div>`);
  made.lastChild.style.minHeight = `${SMALL_PX}px`;
  return made;
};

/** What the reader looks at; it is kept in the address, so that it can be sent to others. */
export class Panel {
  /** `changed()` is called when other numbers are wanted. */
  constructor(quantities, changed) {
    Object.assign(this, { quantities, changed, summaries: [], charts: new Map(), wanted: Object.fromEntries(new URLSearchParams(location.search)) });
    this.small = inTurns((each) => this.drawSmall(each));
    if (this.wanted.statistic) $("statistic").value = this.wanted.statistic;
    $("choice").addEventListener("change", ({ target }) => this.choose(target.id, target.value));
    $("multiples").addEventListener("click", ({ target }) => {
      const { quantity } = target.closest("[data-quantity]")?.dataset ?? {};
      if (!quantity) return;
      this.choose("quantity", quantity);
      $("choice").scrollIntoView({ block: "nearest" });
    });
    document.addEventListener("click", ({ target }) => {
      if (target.dataset.save && this.chart) saveChart(this.chart, $("curve-title").textContent, target.dataset.save).catch(notify);
    });
  }

  get choice() {
    return Object.fromEntries(CHOICES.map((name) => [name, $(name).value]));
  }

  get info() {
    return this.quantities.find(({ name }) => name === $("quantity").value);
  }

  choose(name, value) {
    this.wanted = { ...this.choice, [name]: value };
    const address = new URL(location.href);
    for (const each of CHOICES) address.searchParams.set(each, this.wanted[each]);
    history.replaceState(null, "", address);
    this.draw();
    this.changed(name);
  }

  /** Show these summaries (see summarise_study); `some`: they are of one quantity, and there are others. */
  show(summaries, some = false) {
    Object.assign(this, { summaries, some });
    this.axes = axesOf(summaries);
    this.draw();
  }

  draw() {
    const there = new Map();
    for (const { quantity, position } of this.summaries) there.set(quantity, (there.get(quantity) ?? new Set()).add(position));
    const quantities = this.quantities.filter(({ name }) => this.some || there.has(name));
    choose($("quantity"), quantities.map(({ name, title }) => [name, title]), this.wanted.quantity);
    const positions = [...(there.get($("quantity").value) ?? this.info?.positions ?? [])];
    choose($("position"), positions.map((name) => [name, words(name)]), this.wanted.position);
    choose($("axis"), [...this.axes.keys()].filter((name) => name !== "study").map((name) => [name, heading(name)]), this.wanted.axis ?? firstAxis(this.axes));
    const { position, axis, statistic } = this.choice;
    if (!this.info) return;
    const { name: unit } = shownUnit(this.info.unit);
    $("curve-title").textContent = `${this.info.title}, ${statistic}${unit === "–" ? "" : `, ${unit}`}`;
    const spec = axis && curves(this.info, position, this.summaries, axis, this.axes);
    $("curve-note").textContent = [this.info.convention, spec?.several && BAND, ...this.info.limits.map((limit) => `Limit ${quantity(limit.value, this.info.unit)}: ${limit.applies}, ${limit.source}`)].filter(Boolean).join(" · ");
    if (spec) this.chart = this.drawn(this.chart, $("curve"), { ...spec, limits: statistic === "std" ? [] : spec.limits, height: 340 });
    else if (!this.some || there.has(this.info.name)) {
      this.chart = this.chart?.remove();
      show($("curve"), html`<p class="empty">Nothing varies here: the number is in the table.</p>`);
    } // else its numbers are asked for: the chart stays until they are there
    const small = this.some || !axis ? [] : quantities.map((info) => ({ info, position: [...there.get(info.name)][0], axis }));
    $("multiples").append(...small.filter(({ info }) => !$(`small-${info.name}`)).map(sheet));
    this.small(small);
  }

  drawSmall({ info, position, axis }) {
    const id = `small-${info.name}`;
    const spec = curves(info, position, this.summaries, axis, this.axes);
    if (spec) return this.charts.set(id, this.drawn(this.charts.get(id), $(id), { ...spec, y: { label: "" }, height: SMALL_PX, legend: false }));
    this.charts.get(id)?.remove();
    this.charts.delete(id);
    show($(id), html`<p class="empty">Nothing varies here.</p>`);
  }

  /** Draws again only what is another. */
  drawn(chart, element, spec) {
    const text = JSON.stringify(spec);
    if (chart?.text === text) return chart;
    if (chart) chart.show(spec);
    else element.replaceChildren();
    return Object.assign(chart ?? new Chart(element, spec), { text });
  }
}
