// Numbers, units and times as engineers read them.

// Unit of the API, the unit people use, and the factor to it.
const SHOWN_IN = { m: ["mm", 1e3], N: ["kN", 1e-3], "m/s^2": ["m/s²", 1], "1": ["–", 1] };
const DIGITS = 4;
const THIN = "\u202f";
const MINUS = "\u2212";

/** The unit people use for values in an SI unit, and the factor to it. */
export const shownUnit = (unit) => {
  const [name, factor] = SHOWN_IN[unit] ?? [unit, 1];
  return { name, factor };
};

/** A number with so many significant digits and no exponent unless it is extreme. */
export const digits = (value, significant = DIGITS) => {
  if (value === null || value === undefined) return "–";
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const magnitude = Math.floor(Math.log10(Math.abs(value)));
  if (magnitude < -5 || magnitude > 8) return value.toExponential(significant - 1).replace("-", MINUS);
  const text = value.toFixed(Math.min(20, Math.max(0, significant - 1 - magnitude)));
  return grouped(text).replace("-", MINUS);
};

/** An integer or a decimal with its thousands apart. */
const grouped = (text) => {
  const [whole, fraction] = text.split(".");
  const apart = whole.length > 5 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN) : whole;
  return fraction === undefined ? apart : `${apart}.${fraction}`;
};

/** How many of something. */
export const count = (value) => grouped(String(value));

/** A value in an SI unit with the unit people use. */
export const quantity = (value, unit) => {
  const { name, factor } = shownUnit(unit);
  return name === "–" ? digits(value * factor) : `${digits(value * factor)}${THIN}${name}`;
};

/** A parameter as it was given: no more digits than it has, large and small ones with an exponent. */
export const given = (value) => {
  if (Array.isArray(value)) return value.map(given).join(" – ");
  if (value && typeof value === "object") return Object.values(value).map(given).join(" – ");
  if (typeof value !== "number") return String(value ?? "–");
  const size = Math.abs(value);
  const text = size >= 1e6 || (size > 0 && size < 1e-4) ? value.toExponential() : String(value);
  return text.replace("e+", "e").replace("-", MINUS);
};

/** wheel_rail_force as "wheel rail force". */
export const words = (name) => name.replaceAll("_", " ");

const UNITS_AT_END = {
  _kmh: "km/h", _n_per_m2: "N/m²", _n_per_m: "N/m", _ns_per_m2: "N·s/m²", _ns_per_m: "N·s/m", _kg_per_m: "kg/m",
  _kg_m2: "kg·m²", _nm2: "N·m²", _kg: "kg", _mm: "mm", _m: "m", _s: "s", _pa: "Pa",
};

/** A field's name as words and unit: track.pad_stiffness_n_per_m as "pad stiffness, N/m". */
export const named = (field) => {
  const last = field.split(".").pop();
  const end = Object.keys(UNITS_AT_END).find((each) => last.endsWith(each));
  return end ? `${words(last.slice(0, -end.length))}, ${UNITS_AT_END[end]}` : words(last);
};

/** Seconds as "12 s", "3 min", "2 h 05 min", "3 d 4 h". */
export const duration = (seconds) => {
  if (seconds === null || seconds === undefined) return "–";
  if (seconds < 10) return `${digits(Math.max(0, seconds), 2)} s`;
  if (seconds < 99.5) return `${Math.round(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  if (minutes < 100) return `${minutes} min`;
  const hours = Math.floor(minutes / 60);
  if (hours < 48) return `${hours} h ${String(minutes % 60).padStart(2, "0")} min`;
  return `${Math.floor(hours / 24)} d ${hours % 24} h`;
};

/** An instant in the reader's own time: "14:05:09" today, else "2026-11-22 14:05". */
export const instant = (text) => {
  if (!text) return "–";
  const time = new Date(text);
  const two = (value) => String(value).padStart(2, "0");
  const clock = `${two(time.getHours())}:${two(time.getMinutes())}`;
  if (time.toDateString() === new Date().toDateString()) return `${clock}:${two(time.getSeconds())}`;
  return `${time.getFullYear()}-${two(time.getMonth() + 1)}-${two(time.getDate())} ${clock}`;
};

/** 0.4217 as "42 %"; what is not done is never 100. */
export const percent = (fraction) => `${fraction < 1 ? Math.floor(100 * fraction) : 100}${THIN}%`;
