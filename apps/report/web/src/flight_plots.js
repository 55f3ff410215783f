import { element, section } from './dom.js';
import { toCentimetres, toDegrees } from './format.js';
import { ink } from './palette.js';
import { Strips, codeLegend, runsOf } from './strips.js';
import { TimeChart } from './time_chart.js';

export function trackingViews(page, { ticks, route }) {
  const node = section(
    page,
    'Lateral error',
    'Distance of the true body origin to the true centreline, positive to the left. Grey: the turn at the end of a leg. Nothing where the error is not defined: before following, and at a target.',
  );
  return timeViews(node, ticks, [
    {
      id: 'error',
      label: 'lateral error over time',
      unit: 'cm',
      digits: 2,
      height: 240,
      bands: turns(ticks),
      lines: legs(ticks, route),
      series: [{ name: 'error', values: ticks.error_m.map(toCentimetres), colour: ink.blue }],
    },
  ]);
}

const turns = (ticks) =>
  runsOf(
    ticks.t_s,
    ticks.turning.map((on) => (on ? 1 : null)),
  );

const legs = (ticks, route) =>
  runsOf(ticks.t_s, ticks.leg)
    .filter(([, , leg], k, runs) => k === 0 || runs[k - 1][2] !== leg)
    .map(([from, , leg]) => ({ t_s: from, text: `${route[leg].from} to ${route[leg].to}` }));

export function codeViews(page, { ticks }) {
  const node = section(
    page,
    'Junction codes',
    'True: from the true pose; nothing where a frame is not scored (take-off, turns, docking, arcs). Seen: the recogniser, raw. Smoothed: after hold and window; what the executive acts on.',
  );
  const rows = [
    ['true', ticks.code_true],
    ['seen', ticks.code_raw],
    ['smoothed', ticks.code_smoothed],
  ].map(([name, values]) => ({ name, runs: runsOf(ticks.t_s, values) }));
  node.append(codeLegend(rows));
  return viewsOf(
    [
      new Strips(node, {
        id: 'codes',
        label: 'junction codes over time: true, seen, smoothed',
        end_s: last(ticks.t_s),
        rows,
      }),
    ],
    ticks,
  );
}

export function commandViews(page, { ticks }) {
  const degrees = (name) => ticks[name].map(toDegrees);
  const node = section(
    page,
    'Commands, height and tilt',
    'Solid: commanded, or true where nothing else is said. Dashed: the vehicle’s own estimate, or for tilt what was commanded.',
  );
  return timeViews(node, ticks, [
    {
      id: 'velocity',
      label: 'velocity commands',
      title: 'Velocity, m/s',
      unit: 'm/s',
      digits: 3,
      series: [
        { name: 'forward', values: ticks.command_forward_m_s, colour: ink.blue },
        { name: 'left', values: ticks.command_left_m_s, colour: ink.vermilion },
        { name: 'up', values: ticks.command_up_m_s, colour: ink.green },
        { name: 'forward, estimate', values: ticks.forward_estimate_m_s, colour: ink.sky, dash: 'dashed' },
        { name: 'left, estimate', values: ticks.left_estimate_m_s, colour: ink.orange, dash: 'dashed' },
      ],
    },
    {
      id: 'yaw-rate',
      label: 'yaw rate command',
      title: 'Yaw rate, °/s',
      unit: '°/s',
      series: [{ name: 'yaw rate', values: degrees('command_yaw_rate_rad_s'), colour: ink.purple }],
    },
    {
      id: 'height',
      label: 'height',
      title: 'Height, m',
      unit: 'm',
      digits: 3,
      series: [
        { name: 'true', values: ticks.z_m, colour: ink.blue },
        { name: 'estimate', values: ticks.height_estimate_m, colour: ink.orange, dash: 'dashed' },
      ],
    },
    {
      id: 'tilt',
      label: 'tilt',
      title: 'Tilt, °',
      unit: '°',
      series: [
        { name: 'roll', values: degrees('roll_rad'), colour: ink.blue },
        { name: 'pitch', values: degrees('pitch_rad'), colour: ink.vermilion },
        { name: 'roll, commanded', values: degrees('command_roll_rad'), colour: ink.sky, dash: 'dashed' },
        { name: 'pitch, commanded', values: degrees('command_pitch_rad'), colour: ink.orange, dash: 'dashed' },
      ],
    },
  ]);
}

function timeViews(parent, ticks, list) {
  if (ticks.t_s.length === 0) return [];
  return viewsOf(
    list.map((one) => {
      const box = element(
        'div',
        { class: 'plot' },
        one.title ? element('h3', {}, one.title) : null,
        lineLegend(one.series),
      );
      parent.append(box);
      return new TimeChart(box, { ...one, times: ticks.t_s });
    }),
    ticks,
  );
}

function lineLegend(series) {
  const shown = series.filter((one) => one.values.some((value) => value !== null));
  return shown.length < 2
    ? null
    : element(
        'ul',
        { class: 'legend' },
        shown.map((one) =>
          element(
            'li',
            {},
            element('i', { class: `line ${one.dash ?? ''}`, style: `border-color:${one.colour}` }),
            one.name,
          ),
        ),
      );
}

const last = (list) => list[list.length - 1] ?? 0;

const viewsOf = (charts, ticks) => charts.map((chart) => ({ chart, showAt: (k) => chart.showTime(ticks.t_s[k]) }));
