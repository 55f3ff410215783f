import { element } from './dom.js';

/** Buttons that show and hide the rows of the group in every chart. */
export function chips(rows, { group }, draw) {
  const button = (row) =>
    element(
      'button',
      {
        type: 'button',
        'aria-pressed': String(row.shown),
        'data-row': row.index,
        onclick: () => {
          row.shown = !row.shown;
          document
            .querySelectorAll(`[data-row="${row.index}"]`)
            .forEach((one) => one.setAttribute('aria-pressed', row.shown));
          draw('rows');
        },
      },
      element('i', { class: `line ${row.dash}`, style: `border-color:${row.colour}` }),
      row.label,
    );
  for (const list of document.querySelectorAll('.chips'))
    list.replaceChildren(...rows.filter((row) => row.group === group).map((row) => element('li', {}, button(row))));
}

export const legend = () => element('ul', { class: 'legend chips' });

/** Empties a box and draws into it again whenever the choice or the rows change. */
export function redrawn(parent, draw) {
  const box = element('div', { class: 'plot' });
  parent.append(box);
  return () => {
    box.replaceChildren();
    draw(box);
  };
}
