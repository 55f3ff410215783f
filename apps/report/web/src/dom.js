/** element('div', {class: 'x', onclick: f}, child, 'text', …); null children are left out. */
export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== false) node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

export function section(parent, title, note, ...children) {
  const node = element(
    'section',
    {},
    element('h2', {}, title),
    note ? element('p', { class: 'note' }, note) : null,
    ...children,
  );
  parent.append(node);
  return node;
}

/** A table with a header row; cells are texts or nodes, rows may be {cells, class}. */
export function table(head, rows, attributes = {}) {
  const cells = (tag, list) => list.map((cell) => element(tag, {}, cell ?? '–'));
  return element(
    'div',
    { class: 'scroll' },
    element(
      'table',
      attributes,
      element('thead', {}, element('tr', {}, cells('th', head))),
      element(
        'tbody',
        {},
        rows.map((row) => element('tr', { class: row.class ?? null }, cells('td', row.cells ?? row))),
      ),
    ),
  );
}

/** A labelled choice; calls back with the value, at once and on change. */
export function choice(label, options, choose) {
  const select = element(
    'select',
    { onchange: () => choose(select.value) },
    options.map(({ value, text }) => element('option', { value }, text)),
  );
  return element('label', { class: 'choice' }, label, ' ', select);
}
