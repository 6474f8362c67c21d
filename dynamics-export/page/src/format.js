// Numbers as they are shown.

const DEGREE = 180 / Math.PI;

/** A number of about five digits, with as many decimals as its size leaves: columns keep their width. NaN is not known. */
export function plain(x) {
  if (Number.isNaN(x)) return "–";
  if (!Number.isFinite(x)) return String(x);
  const size = Math.abs(x);
  if (size < 5e-13) return "0";
  if (size < 1e-3 || size >= 1e6) return x.toExponential(2);
  const decimals = size < 10 ? 4 : size < 100 ? 3 : size < 1000 ? 2 : 1;
  return x.toFixed(decimals);
}

/** A number as short as it can be said in some digits. */
export function short(x, digits = 4) {
  return String(Number(x.toPrecision(digits)));
}

/** Multiples of pi as a person writes them. */
function ofPi(x) {
  for (const parts of [1, 2, 3, 4, 6, 12]) {
    const count = (x / Math.PI) * parts;
    const whole = Math.round(count);
    if (whole === 0 || Math.abs(count - whole) > 1e-9) continue;
    const sign = whole < 0 ? "-" : "";
    const times = Math.abs(whole) === 1 ? "" : String(Math.abs(whole));
    return `${sign}${times}π${parts === 1 ? "" : `/${parts}`}`;
  }
  return null;
}

/** Units of a page that shows angles in degrees, or in radians. */
export function units(inDegrees) {
  const angleUnit = inDegrees ? "°" : "rad";
  const factor = (type) => (type === "revolute" && inDegrees ? DEGREE : 1);
  return {
    inDegrees,
    angleUnit,
    factor,
    /** Units of position, velocity, acceleration and force of a joint. */
    position: (type) => (type === "revolute" ? angleUnit : "m"),
    velocity: (type) => (type === "revolute" ? `${angleUnit}/s` : "m/s"),
    acceleration: (type) => (type === "revolute" ? `${angleUnit}/s²` : "m/s²"),
    force: (type) => (type === "revolute" ? "N m" : "N"),
    /** An angle with its unit, as labels have it. */
    angle: (x) => (inDegrees ? `${short(x * DEGREE)}°` : `${short(x)} rad`),
    length: (x) => `${short(x)} m`,
    number: (x) => (Math.abs(x) < 1e-12 ? "0" : short(x)),
    /** An angle of the table without unit. */
    cell: (x) => (inDegrees ? short(x * DEGREE, 6) : (ofPi(x) ?? short(x, 6))),
  };
}
