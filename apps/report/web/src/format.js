const degrees = 180 / Math.PI;

export const toDegrees = (rad) => (rad === null ? null : rad * degrees);
export const toCentimetres = (m) => (m === null ? null : m * 100);

export const fixed = (value, digits) => (Number.isFinite(value) ? value.toFixed(digits).replace('-', '−') : '–');
export const centimetres = (m) => (Number.isFinite(m) ? `${fixed(m * 100, Math.abs(m) < 0.0995 ? 1 : 0)} cm` : '–');
export const percent = (share, digits = 2) => (Number.isFinite(share) ? `${fixed(share * 100, digits)} %` : '–');
export const seconds = (s) => (Number.isFinite(s) ? `${fixed(s, 1)} s` : '–');
export const place = ({ x_m, y_m }) => (Number.isFinite(x_m) ? `(${fixed(x_m, 3)}, ${fixed(y_m, 3)}) m` : '–');
