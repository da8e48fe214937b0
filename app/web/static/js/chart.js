// Charts: uPlot in the page's colours, as one needs it here. Global uPlot comes from vendor/.

import { digits, given } from "./format.js";
import { html, show } from "./html.js";

const HUES = 7;
const FONT = '12px system-ui, "Segoe UI", Roboto, sans-serif';
const HEIGHT = 240;
const FAR = 1.5; // a limit that far above all values would leave these no room

const colours = new Map(); // as they were found, since to find one takes a look at the whole page
document.addEventListener("colours", () => colours.clear());

/** A colour of the page's style sheet as the theme has it now, such as "--ink". */
export const colour = (name) => {
  if (!colours.has(name)) {
    const probe = document.createElement("i");
    probe.style.color = `var(${name})`;
    document.body.append(probe);
    colours.set(name, getComputedStyle(probe).color);
    probe.remove();
  }
  return colours.get(name);
};

/** The n-th dash of lines, as canvas and SVG take it; the first is none. */
export const dash = (n = 0) => [[], [7, 4], [2, 3], [9, 3, 2, 3]][n % 4];

/** The n-th colour that colour-blind readers tell from the others. */
export const hue = (n) => colour(`--hue-${n % HUES}`);

const faded = (rgb, alpha) => rgb.replace("rgb(", "rgba(").replace(")", `, ${alpha})`);

/**
 * A chart in an element of fixed height.
 *
 * spec: {
 *   label: what it shows, for who cannot see it; height: px, a legend comes below it; legend: false;
 *   x: {label, values: numbers, ticks: words for 0, 1, … instead of numbers, log: true};
 *   y: {label, log: true};
 *   series: [{label, values, hue: n, dash: n, points: false, low: values, high: values}], the latter two a band:
 *     filled, or outlined where lines are dashed, so that those of one colour can be told apart;
 *   limits: [{value, label}] horizontal lines; marks: [{value, label}] vertical ones;
 *   zoomed: (min, max) => … when the reader has chosen a part of x; sync: charts of one name share cursor and zoom
 * }
 */
export class Chart {
  constructor(element, spec) {
    this.element = element;
    element.classList.add("chart");
    element.style.minHeight = `${(spec.height ?? HEIGHT) + (spec.legend === false ? 0 : 24)}px`;
    element.setAttribute("role", "group");
    this.redraw = () => this.show(this.spec);
    document.addEventListener("colours", this.redraw);
    this.resized = new ResizeObserver(() => this.plot?.setSize({ width: this.width, height: this.height }));
    this.resized.observe(element);
    this.show(spec);
  }

  get width() {
    return Math.max(200, this.element.clientWidth);
  }

  get height() {
    return this.spec.height ?? HEIGHT;
  }

  /** Draw another thing in the same place. */
  show(spec) {
    this.spec = spec;
    this.plot?.destroy();
    this.element.setAttribute("aria-label", spec.label);
    this.plot = new uPlot(this.options(), this.columns(), this.element);
    this.keys();
    const canvas = this.element.querySelector("canvas");
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", spec.label);
  }

  /** Lines as they are drawn, before their names in the legend. */
  keys() {
    const rows = [...this.element.querySelectorAll(".u-series:not(.bound)")].slice(1);
    rows.forEach((row, n) => {
      const each = this.spec.series[n];
      const stroke = hue(each.hue ?? 0);
      show(row.querySelector(".u-marker"), html`<svg width="28" height="10" aria-hidden="true">${each.low && !each.dash && html`<rect width="28" height="10" fill="${stroke}" fill-opacity="0.18"/>`}
        <line x2="28" y1="5" y2="5" stroke="${stroke}" stroke-width="2" stroke-dasharray="${dash(each.dash).join(" ")}"/></svg>`);
    });
  }

  /** Other values of the same series, without a change of the visible part. */
  update(x, values) {
    this.spec = { ...this.spec, x: { ...this.spec.x, values: x } };
    this.spec.series = this.spec.series.map((each, n) => ({ ...each, ...values[n] }));
    this.plot.setData(this.columns(), false);
    this.plot.redraw();
  }

  remove() {
    document.removeEventListener("colours", this.redraw);
    this.resized.disconnect();
    this.plot.destroy();
  }

  columns() {
    const { x, series } = this.spec;
    return [x.values, ...series.flatMap((s) => (s.low ? [s.values, s.high, s.low] : [s.values]))];
  }

  options() {
    const { x, y, series, sync, zoomed } = this.spec;
    const [ink, line] = [colour("--soft"), colour("--line")];
    const axis = { stroke: ink, font: FONT, labelFont: FONT, grid: { stroke: line, width: 1 }, ticks: { stroke: line, width: 1, size: 4 }, labelGap: 0 };
    const bands = [];
    const drawn = [{ label: x.label, value: (_, value) => (value === null ? "" : x.ticks ? x.ticks[value] : given(value)) }];
    for (const each of series) {
      const stroke = hue(each.hue ?? 0);
      const points = each.points ?? true;
      drawn.push({
        label: each.label, stroke, width: 1.5, dash: dash(each.dash), spanGaps: true, pxAlign: 0,
        points: { show: points, size: 6, fill: points ? stroke : undefined }, value: (_, value, __, at) => (at === null ? "" : digits(value)),
      });
      if (each.low) {
        if (!each.dash) bands.push({ series: [drawn.length, drawn.length + 1], fill: faded(stroke, 0.18) });
        const outline = { class: "bound", stroke: faded(stroke, 0.8), width: each.dash ? 1 : 0, dash: dash(each.dash), points: { show: false } };
        drawn.push(outline, { ...outline });
      }
    }
    const last = (x.ticks?.length ?? 0) - 1;
    return {
      width: this.width, height: this.height, series: drawn, bands,
      scales: {
        x: { time: false, distr: x.log ? 3 : 1, ...(x.ticks && { range: () => [-0.4, last + 0.4] }) },
        y: { distr: y.log ? 3 : 1, ...(!y.log && { range: (_, low, high) => this.range(low, high) }) },
      },
      axes: [
        { ...axis, label: x.label, labelSize: 18, size: 28, ...(x.ticks && { splits: () => x.ticks.map((_, n) => n), values: () => x.ticks }) },
        { ...axis, label: y.label, labelSize: 18, size: 54, values: (_, found) => found.map((value) => (value === null ? "" : given(Number(value.toPrecision(6))))) },
      ],
      cursor: { y: false, drag: { x: Boolean(zoomed) || !x.ticks, y: false }, points: { size: 8 }, ...(sync && { sync: { key: sync } }) },
      hooks: {
        draw: [(plot) => this.lines(plot)],
        setSelect: zoomed ? [(plot) => plot.select.width && zoomed(plot.posToVal(plot.select.left, "x"), plot.posToVal(plot.select.left + plot.select.width, "x"))] : [],
        setSeries: [(plot, n, { show }) => show !== undefined && plot.series[n + 1]?.class === "bound" && [1, 2].forEach((k) => plot.setSeries(n + k, { show }))],
      },
      legend: { show: this.spec.legend !== false, markers: { width: 0 } },
    };
  }

  /** The range of values: with zero where that is near, and with limits that are not far off. */
  range(low, high) {
    if (low === null) return [0, 1];
    const near = (this.spec.limits ?? []).map((limit) => limit.value).filter((value) => value < FAR * high);
    const [bottom, top] = [Math.min(low, ...near), Math.max(high, ...near)];
    const span = top - bottom || Math.abs(top) || 1;
    const floor = bottom >= 0 && bottom < 0.5 * top ? 0 : bottom - 0.08 * span;
    return [floor, top + 0.08 * span];
  }

  lines(plot) {
    const { limits = [], marks = [] } = this.spec;
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.strokeStyle = ctx.fillStyle = colour("--warn");
    ctx.lineWidth = devicePixelRatio;
    ctx.textBaseline = "alphabetic";
    ctx.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
    ctx.setLineDash([4 * devicePixelRatio, 3 * devicePixelRatio]);
    const line = (x0, y0, x1, y1) => {
      ctx.beginPath();
      ctx.moveTo(x0, y0);
      ctx.lineTo(x1, y1);
      ctx.stroke();
    };
    for (const { value, label } of limits) {
      const y = Math.round(plot.valToPos(value, "y", true));
      line(bbox.left, y, bbox.left + bbox.width, y);
      ctx.textAlign = "right";
      ctx.fillText(label, bbox.left + bbox.width - 4, y - 4);
    }
    marks.forEach(({ value, label }, n) => {
      const x = Math.round(plot.valToPos(value, "x", true));
      line(x, bbox.top, x, bbox.top + bbox.height);
      ctx.textAlign = "left";
      ctx.fillText(label, x + 4, bbox.top + (14 + 14 * (n % 4)) * devicePixelRatio);
    });
    ctx.restore();
  }
}
