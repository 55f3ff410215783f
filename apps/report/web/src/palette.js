// Okabe and Ito's colours, which colour-blind readers tell apart.
export const ink = {
  blue: '#0072B2',
  sky: '#56B4E9',
  green: '#009E73',
  vermilion: '#D55E00',
  orange: '#E69F00',
  purple: '#CC79A7',
  yellow: '#F0E442',
  black: '#000000',
  grey: '#8a8a8a',
  pale: '#d9d9d9',
};

// Yellow is too faint for a thin line on white: an olive of the same hue stands in for it there.
const lines = [ink.blue, ink.vermilion, ink.green, ink.orange, ink.purple, ink.sky, ink.black, ink.grey, '#8f7c00'];
export const lineColour = (index) => lines[index % lines.length];

export const symbols = ['circle', 'triangle', 'rect', 'diamond', 'pin', 'arrow', 'roundRect', 'circle', 'triangle'];

/** Junction codes J0 to J9: what they mean, and colours on which the name can be read. */
export const codes = [
  { meaning: 'start disc', fill: ink.black, text: '#fff' },
  { meaning: 'unrecognised', fill: '#ffffff', text: '#000' },
  { meaning: 'straight', fill: ink.pale, text: '#000' },
  { meaning: 'cross ┼', fill: ink.blue, text: '#fff' },
  { meaning: 'corner right ┌', fill: ink.orange, text: '#000' },
  { meaning: 'corner left ┐', fill: ink.sky, text: '#000' },
  { meaning: '┴ left behind', fill: ink.green, text: '#fff' },
  { meaning: '┬ coming up', fill: ink.vermilion, text: '#fff' },
  { meaning: 'T right ├', fill: ink.purple, text: '#000' },
  { meaning: 'T left ┤', fill: ink.yellow, text: '#000' },
];
