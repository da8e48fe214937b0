// A chart as a file: SVG made of what the chart shows, and PNG made of that.

import { colour, dash, hue } from "./chart.js";
import { html } from "./html.js";
import { save } from "./save.js";

const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [720, 420, 64, 16, 34, 46];
const SCALE = 2;

/** The text of an SVG of a Chart, in the colours it has on the page. */
export const svg = ({ spec, plot }, title) => {
  const entries = spec.series.length;
  const legend = entries > 1 ? 18 * entries : 0;
  const bottom = HEIGHT - BOTTOM;
  const scale = (name, from, to) => {
    const { min, max, distr } = plot.scales[name];
    const f = distr === 3 ? Math.log10 : Number;
    return (value) => (from + ((f(value) - f(min)) / (f(max) - f(min))) * (to - from)).toFixed(1);
  };
  const [x, y] = [scale("x", LEFT, WIDTH - RIGHT), scale("y", bottom, TOP)];
  const [ink, soft, line, paper, warn] = ["--ink", "--soft", "--line", "--paper", "--warn"].map(colour);
  const ticks = (n) => plot.axes[n]._splits.map((split, k) => [split, plot.axes[n]._values[k]]).filter(([, text]) => text !== "" && text !== null);
  const within = (value, name) => value >= plot.scales[name].min && value <= plot.scales[name].max;
  const points = (values) => spec.x.values.map((at, n) => [at, values[n]]).filter(([, value]) => value !== null && value !== undefined).map(([at, value]) => [x(at), y(value)]);
  const path = (found) => found.map(([a, b]) => `${a},${b}`).join(" ");
  const curve = (each) => {
    const stroke = hue(each.hue ?? 0);
    const found = points(each.values);
    const dashes = dash(each.dash).join(" ");
    const outline = (values) => html`<polyline points="${path(points(values))}" fill="none" stroke="${stroke}" stroke-opacity="0.8" stroke-dasharray="${dashes}"/>`;
    const band = each.low && (each.dash ? [each.low, each.high].map(outline) : html`<polygon points="${path([...points(each.low), ...points(each.high).reverse()])}" fill="${stroke}" fill-opacity="0.16"/>`);
    return html`${band}
<polyline points="${path(found)}" fill="none" stroke="${stroke}" stroke-width="1.6" stroke-dasharray="${dashes}"/>
${(each.points ?? true) && found.map(([a, b]) => html`<circle cx="${a}" cy="${b}" r="2.6" fill="${stroke}"/>`)}`;
  };
  return String(html`<svg xmlns="http://www.w3.org/2000/svg" width="${WIDTH}" height="${HEIGHT + legend}" viewBox="0 0 ${WIDTH} ${HEIGHT + legend}" font-family="system-ui, sans-serif" font-size="12">
<title>${spec.label}</title><rect width="100%" height="100%" fill="${paper}"/>
<text x="${LEFT}" y="20" fill="${ink}" font-size="14" font-weight="600">${title}</text>
${ticks(1).filter(([at]) => within(at, "y")).map(([at, text]) => html`<path d="M${LEFT} ${y(at)}H${WIDTH - RIGHT}" stroke="${line}"/><text x="${LEFT - 6}" y="${y(at)}" dy="4" text-anchor="end" fill="${soft}">${text}</text>`)}
${ticks(0).filter(([at]) => within(at, "x")).map(([at, text]) => html`<path d="M${x(at)} ${TOP}V${bottom}" stroke="${line}"/><text x="${x(at)}" y="${bottom + 16}" text-anchor="middle" fill="${soft}">${text}</text>`)}
<text x="${(LEFT + WIDTH - RIGHT) / 2}" y="${bottom + 36}" text-anchor="middle" fill="${soft}">${spec.x.label}</text>
<text transform="translate(16 ${(TOP + bottom) / 2}) rotate(-90)" text-anchor="middle" fill="${soft}">${spec.y.label}</text>
${(spec.limits ?? []).filter(({ value }) => within(value, "y")).map(({ value, label }) => html`<path d="M${LEFT} ${y(value)}H${WIDTH - RIGHT}" stroke="${warn}" stroke-dasharray="4 3"/><text x="${WIDTH - RIGHT - 4}" y="${y(value) - 4}" text-anchor="end" fill="${warn}">${label}</text>`)}
${(spec.marks ?? []).filter(({ value }) => within(value, "x")).map(({ value, label }) => html`<path d="M${x(value)} ${TOP}V${bottom}" stroke="${warn}" stroke-dasharray="4 3"/><text x="${x(value)}" dx="4" y="${TOP + 12}" fill="${warn}">${label}</text>`)}
${spec.series.map(curve)}
${legend > 0 && spec.series.map((each, n) => html`<path d="M${LEFT} ${HEIGHT + 18 * n}h26" stroke="${hue(each.hue ?? 0)}" stroke-width="2" stroke-dasharray="${dash(each.dash).join(" ")}"/><text x="${LEFT + 34}" y="${HEIGHT + 18 * n}" dy="4" fill="${ink}">${each.label}</text>`)}
</svg>`);
};

/** Let the reader keep a chart as "svg" or "png". */
export const saveChart = async (chart, title, kind) => {
  const name = `${title.toLowerCase().replace(/[^a-z0-9]+/g, "-")}.${kind}`;
  const text = svg(chart, title);
  if (kind === "svg") {
    save(new Blob([text], { type: "image/svg+xml" }), name);
    return;
  }
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [SCALE * image.width, SCALE * image.height];
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  canvas.toBlob((blob) => save(blob, name), "image/png");
};
