// Differences along one axis of a study, such as the discontinuous slab less the continuous one.

import { get } from "./api.js";
import { digits, given, shownUnit, words } from "./format.js";
import { $, html, show } from "./html.js";
import { heading } from "./sweep.js";
import { Table } from "./table.js";

const averages = new Table($("averages"), "Mean differences of every quantity");
const pairs = new Table($("pairs"), "Differences of the chosen quantity");

const relative = (value) => (value === null ? "–" : `${value > 0 ? "+" : ""}${digits(100 * value, 3)}`);

const options = (select, values, labels) => {
  const chosen = select.value;
  show(select, values.map((value, n) => html`<option value="${value}">${labels[n]}</option>`));
  select.value = values.includes(chosen) ? chosen : values[0];
};

const column = (key, label, value, text = value, number = false, unit = "") => ({ key, label, unit, value, text, number });

/** Fill the section from compare_study, for what the panel shows. */
export const showDifferences = async (path, panel) => {
  const axes = [...panel.axes.keys()].toSorted((a, b) => (b === "slab") - (a === "slab"));
  $("differences").hidden = !axes.length;
  if (!axes.length) return;
  options($("between"), axes, axes.map(heading));
  const axis = $("between").value;
  const values = panel.axes.get(axis);
  options($("baseline"), values.map((value) => (typeof value === "string" ? value : JSON.stringify(value))), values.map(given));
  const { quantity, position, statistic } = panel.choice;
  const found = await get(`${path}/comparison`, { axis, statistic, baseline: $("baseline").value, quantity: panel.some ? quantity : null });
  const title = Object.fromEntries(panel.quantities.map((each) => [each.name, each.title]));
  const scaled = (row, key) => shownUnit(row.unit).factor * row[key];
  averages.show([
    column("quantity", "quantity", (row) => title[row.quantity] ?? row.quantity),
    ...(values.length > 2 ? [column("at", heading(axis), (row) => row.at, (row) => given(row.at), typeof values[0] === "number")] : []),
    column("relative", "relative", (row) => row.relative, (row) => relative(row.relative), true, "%"),
    column("absolute", "absolute", (row) => scaled(row, "absolute"), (row) => digits(scaled(row, "absolute")), true),
    column("std", "± std", (row) => row.absolute_std, (row) => (row.absolute_std === null ? "–" : digits(scaled(row, "absolute_std"), 3)), true),
    column("unit", "unit", (row) => shownUnit(row.unit).name),
    column("position", "position", (row) => words(row.position)),
    column("groups", "pairs", (row) => row.groups, (row) => row.groups, true),
  ], found.averages);
  const own = found.groups.filter((group) => group.quantity === quantity && group.position === position);
  const rows = own.flatMap(({ differences, ...group }) => differences.map((each) => ({ ...group, ...each })));
  const unit = shownUnit(panel.info.unit).name;
  $("pairs-title").textContent = `${panel.info.title}, ${statistic}, pair by pair`;
  pairs.show([
    ...Object.keys(rows[0]?.conditions ?? {}).map((name) => column(name, heading(name).split(", ")[0], (row) => row.conditions[name], (row) => given(row.conditions[name]), typeof rows[0].conditions[name] === "number", heading(name).split(", ")[1])),
    column("baseline", given(found.baseline), (row) => row.baseline_value, (row) => digits(scaled(row, "baseline_value")), true, unit),
    ...(values.length > 2 ? [column("at", heading(axis), (row) => row.at, (row) => given(row.at), true)] : []),
    column("value", values.length > 2 ? "value" : given(values.find((value) => value !== found.baseline)), (row) => row.value, (row) => digits(scaled(row, "value")), true, unit),
    column("relative", "difference", (row) => row.relative, (row) => relative(row.relative), true, "%"),
  ], rows);
};
