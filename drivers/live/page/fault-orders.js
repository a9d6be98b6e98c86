// Sets and clears faults through the services of /drydock/faults. Hidden if the server has no such services.
import { by, clock, make } from './dom.js';
import { inForce } from './faults.js';

const section = by('orders'), form = section.querySelector('form');
const units = { mps: 'm/s', degps: '°/s', mps2: 'm/s²', pa: 'Pa', deg: '°', rpm: 'rpm', m: 'm', hz: 'Hz', db: 'dB', s: 's' };
let services = new Map(), words = {}, shown = '';

const ask = (name, request) => services.get(`/drydock/faults/${name}`)(request);
const options = (list) => list.map(([value, text]) => new Option(text ?? value, value));

// "specific_force_mps2" -> "specific force, m/s²", "db" -> "dB", "bytes" -> "bytes"
function nameOf(key) {
  const parts = key.split('_'), unit = units[parts.at(-1)];
  if (parts.length === 1) return unit ?? key;
  return unit === undefined ? key : `${parts.slice(0, -1).join(' ')}, ${unit}`;
}

// A quantity is one number, or one for each axis. Other amounts have bounds, and most have a usual value.
function field({ key, usual, lowest, highest }) {
  const bound = (x) => (Math.abs(x) < 1e5 ? x : x.toExponential().replace('+', ''));
  const input = make('input', { name: 'amount', size: 11, value: usual ?? '', placeholder: lowest === undefined ? 'x or x,y,z' : '' });
  input.dataset.key = key;
  return make('label', {}, lowest === undefined ? nameOf(key) : `${nameOf(key)} (${bound(lowest)} to ${bound(highest)})`, input);
}

const wordNow = () => words[form.elements.device.value]?.find(({ fault }) => fault === form.elements.fault.value);

// Shows the amounts of the chosen fault. If there are several quantities, the user selects one by its name.
function showAmounts() {
  const word = wordNow();
  by('meaning').textContent = word?.meaning ?? '';
  const { amounts = [], more = [] } = word ?? {};
  const fields = amounts.slice(0, 1).concat(more).map(field);
  if (amounts.length > 1) {
    const input = fields[0].querySelector('input');
    const choice = make('select', { name: 'quantity' }, ...options(amounts.map(({ key }) => [key, nameOf(key)])));
    choice.onchange = () => { input.dataset.key = choice.value; };
    fields[0].replaceChildren('Amount', input);
    fields.unshift(make('label', {}, 'Quantity', choice));
  }
  by('amounts').replaceChildren(...fields);
}

function showWords() {
  const { device, fault } = form.elements;
  const before = fault.value, layers = new Map();
  for (const { layer, fault: word } of words[device.value] ?? []) layers.set(layer, [...(layers.get(layer) ?? []), [word]]);
  fault.replaceChildren(...[...layers].map(([label, list]) => make('optgroup', { label }, ...options(list))));
  if ([...fault.options].some(({ value }) => value === before)) fault.value = before;
  showAmounts();
}

function say(className, textContent) { Object.assign(by('answer'), { className, textContent }); }

async function obeyed(name, request) {
  try {
    say('ok', (await ask(name, request)).lines.join('; '));
  } catch ({ message }) {
    say('error', `refused: ${message}`);
  }
}

// Sends the same values as `drydock fault RIG set DEVICE FAULT KEY=VALUE ... --for TIME`.
function set(event) {
  event.preventDefault();
  const { device, fault, for: time } = form.elements;
  const pairs = [...by('amounts').querySelectorAll('input')].filter(({ value }) => value.trim()).map(({ dataset, value }) => `${dataset.key}=${value.trim()}`);
  obeyed('set', { device: device.value, fault: fault.value, with: pairs, for: time.value.trim() });
}

// Redraws only if the faults in force have changed, so that the focus stays.
export function showOrders() {
  if (section.hidden) return;
  const current = inForce(), key = current.map(({ device, text, since, until }) => `${device} ${text} ${since} ${until}`).join('\n');
  if (key === shown) return;
  shown = key;
  by('in-force').replaceChildren(...current.map(({ device, name, text, until }) => make('li', {},
    make('span', {}, `${text}${until === null ? ', until cleared' : `, until ${clock(until)} UTC`}`),
    make('button', { type: 'button', ariaLabel: `Clear ${text}`, onclick: () => obeyed('clear', { device, fault: name }) }, 'Clear'))));
}

export async function takeServices(offered) {
  services = offered;
  section.hidden = !offered.has('/drydock/faults/set');
  if (section.hidden) return;
  try { words = await ask('words', {}); } catch ({ message }) { say('error', message); return; }
  say('', '');
  const { device } = form.elements, before = device.value;
  device.replaceChildren(...options(Object.keys(words).map((name) => [name])));
  if (before in words) device.value = before;
  showWords();
}

form.onsubmit = set;
form.elements.device.onchange = showWords;
form.elements.fault.onchange = showAmounts;
