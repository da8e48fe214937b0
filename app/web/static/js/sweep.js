// What a sweep is seen by: which axes it has, and curves of one quantity along one of them, grouped by the others.

import { given, named, quantity, shownUnit } from "./format.js";

const key = (value) => JSON.stringify(value);

const inOrder = (values) =>
  values.every((value) => typeof value === "number") ? values.toSorted((a, b) => a - b) : values;

/** What varies in summaries: names of conditions, each with its different values. */
export const axesOf = (summaries) => {
  const found = new Map();
  for (const { conditions } of summaries) {
    for (const [name, value] of Object.entries(conditions)) {
      if (!found.has(name)) found.set(name, new Map());
      found.get(name).set(key(value), value);
    }
  }
  const axes = [...found].map(([name, values]) => [name, inOrder([...values.values()])]);
  return new Map(axes.filter(([, values]) => values.length > 1));
};

/** The axis to begin with: speed, or else the longest one of numbers. */
export const firstAxis = (axes) => {
  if (axes.has("speed_kmh")) return "speed_kmh";
  const numeric = [...axes].filter(([, values]) => values.every((value) => typeof value === "number"));
  return (numeric.length ? numeric : [...axes]).toSorted(([, a], [, b]) => b.length - a.length)[0]?.[0];
};

/** The value of an axis in words: "continuous slab", "200 km/h". */
export const said = (name, value) => {
  if (name === "study") return value;
  if (name === "slab") return `${value} slab`;
  if (name === "percentile") return `${given(value)} %`;
  const [what, unit] = named(name).split(", ");
  const band = name.startsWith("wavelength_band");
  return band ? `${given(value)} m` : `${what} ${given(value)}${unit ? ` ${unit}` : ""}`;
};

/** The heading of an axis. */
export const heading = (name) =>
  ({ percentile: "percentile, %", wavelength_band_m: "band of wavelengths, m" })[name] ?? named(name);

/** The spec of a chart of one quantity at one position along an axis; null if there is nothing to draw. */
export const curves = (info, position, summaries, axis, axes) => {
  const own = summaries.filter((each) => each.quantity === info.name && each.position === position && axis in each.conditions);
  if (!own.length) return null;
  const { name: unit, factor } = shownUnit(info.unit);
  const values = axes.get(axis);
  const numeric = values.every((value) => typeof value === "number");
  const place = new Map(values.map((value, n) => [key(value), n]));
  const others = [...axes].filter(([name]) => name !== axis).toSorted(([name, a], [other, b]) => (other === "study") - (name === "study") || b.length - a.length);
  const groups = new Map();
  for (const summary of own) {
    const parts = others.map(([name, all]) => [name, all.findIndex((value) => key(value) === key(summary.conditions[name]))]);
    const id = key(parts);
    if (!groups.has(id)) groups.set(id, { parts, summaries: [] });
    groups.get(id).summaries.push(summary);
  }
  const column = (group, pick) => {
    const found = Array(values.length).fill(null);
    for (const summary of group.summaries) found[place.get(key(summary.conditions[axis]))] = factor * pick(summary);
    return found;
  };
  const several = own.some(({ count }) => count > 1);
  const series = [...groups.values()].toSorted((a, b) => key(a.parts).localeCompare(key(b.parts), "en", { numeric: true })).map((group) => ({
    label: others.map(([name, all], n) => group.parts[n][1] >= 0 && said(name, all[group.parts[n][1]])).filter(Boolean).join(", ") || info.title,
    hue: Math.max(0, group.parts[0]?.[1] ?? 0),
    dash: group.parts.slice(1).reduce((sum, [, n]) => sum + Math.max(0, n), 0),
    values: column(group, ({ quantiles, mean, count }) => (count > 1 ? quantiles.p50 : mean)),
    ...(several && { low: column(group, ({ quantiles }) => quantiles.p5), high: column(group, ({ quantiles }) => quantiles.p95) }),
  }));
  return {
    label: `${info.title} against ${heading(axis)}`,
    x: { label: heading(axis), values: numeric ? values : values.map((_, n) => n), ...(!numeric && { ticks: values.map(given) }) },
    y: { label: unit === "–" ? info.title : `${info.title}, ${unit}` },
    series,
    several,
    limits: info.limits.map((limit) => ({ value: factor * limit.value, label: quantity(limit.value, info.unit) })),
  };
};
