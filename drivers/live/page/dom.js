// Helpers for the DOM that all parts of the page use.
export const by = (id) => document.getElementById(id);
export const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
export const colours = ['--c1', '--c2', '--c3', '--c4', '--c5', '--c6'];
export const degree = Math.PI / 180;

// The one convention of axes, said beside the plots.
export const axes = {
  body: 'forward, starboard, down',
  map: 'north, east, down',
  turns: 'starboard side down, bow up',
  heading: 'clockwise from north',
};

// make('p', { className: 'x' }, 'text', child)
export function make(tag, properties = {}, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

// Gives a place for figures and shows its section, which is hidden as long as it has none.
export function place(id) {
  const parent = by(id);
  parent.closest('section').hidden = false;
  return parent;
}

// Inserts by title, so that a figure has the same place every time.
export function insert(parent, figure) {
  parent.insertBefore(figure, [...parent.children].find(({ ariaLabel }) => ariaLabel.localeCompare(figure.ariaLabel) > 0) ?? null);
}

export const seconds = ({ sec, nanosec }) => sec + nanosec / 1e9;
export const clock = (t) => new Date(t * 1000).toISOString().slice(11, 19); // UTC
export function number(x) {
  if (!Number.isFinite(x)) return '–';
  const size = Math.abs(x);
  if (size < 1e-9) return '0';
  return size < 1e-3 ? x.toExponential(1) : String(Number(x.toPrecision(size < 1 ? 3 : 4)));
}

const dark = matchMedia('(prefers-color-scheme: dark)');
export const onTheme = (callback) => dark.addEventListener('change', callback);
