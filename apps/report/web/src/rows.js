import { lineColour, symbols } from './palette.js';

export const metrics = [
  ['rmse_m', 'RMSE', 'cm', 100],
  ['max_m', 'largest error', 'cm', 100],
  ['mean_m', 'mean size of the error', 'cm', 100],
  ['p95_m', '95th percentile of the error', 'cm', 100],
  ['settled_rmse_m', 'settled RMSE', 'cm', 100],
  ['turn_max_m', 'largest error at turns', 'cm', 100],
  ['terminal_error_m', 'terminal error', 'cm', 100],
  ['duration_s', 'duration', 's', 1],
  ['tilt_rate_rms_rad_s', 'tilt rate, RMS', '°/s', 180 / Math.PI],
].map(([name, text, unit, scale]) => ({ name, text, unit, scale }));

export const metricNamed = (name) => metrics.find((one) => one.name === name);

/** A row of the tables: a controller with its parameters on a floor at a speed, with what it is drawn with. */
export function rowsOf({ comparison, errors, mean_ci95 }) {
  const laws = [...new Set(comparison.controllers.map(lawOf))];
  return comparison.controllers.map((row, index) => {
    const k = laws.indexOf(lawOf(row));
    return {
      ...row,
      index,
      group: groupOf(row),
      label: labelOf(row),
      colour: lineColour(k),
      symbol: symbols[k % symbols.length],
      dash: row.tuned ? 'dashed' : 'solid',
      errors: errors.rows[index],
      ci95: mean_ci95[index],
      flights: flightsOf(comparison, row),
      shown: true,
    };
  });
}

export const groupOf = (row) =>
  [
    row.title && row.title !== row.layout ? row.title : '',
    row.layout,
    row.own_speed ? 'own speeds' : row.speed_m_s === null ? 'drawn speeds' : `${row.speed_m_s} m/s`,
  ]
    .filter(Boolean)
    .join(', ');

/** What has a colour of its own. */
const lawOf = (row) => `${row.name} ${row.variant}`;

export const labelOf = (row) => [row.name, row.tuned ? 'tuned' : '', row.variant].filter(Boolean).join(' ');

const flightsOf = ({ flights }, row) =>
  flights.filter(
    (one) =>
      one.controller === row.name &&
      one.tuned === row.tuned &&
      one.variant === row.variant &&
      one.layout === row.layout &&
      one.speed_m_s === row.speed_m_s &&
      row.instructions.includes(one.instruction),
  );
