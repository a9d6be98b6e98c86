// Starts and stops a recording through the services of /drydock/recording. Hidden if the server has no such services.
import { by, clock, number } from './dom.js';

const section = by('recording'), button = section.querySelector('button'), says = section.querySelector('[role=status]');
const period = 1000; // ms between questions: another viewer may have started or stopped it
let services = new Map(), on = false, asking = false;

const ask = (name) => services.get(`/drydock/recording/${name}`)({});

function show({ recording, file, since_s: since, bytes, last }) {
  on = recording;
  button.textContent = recording ? 'Stop' : 'Start';
  says.className = '';
  says.textContent = recording ? `${file}, since ${clock(since)} UTC, ${number(bytes / 1e6)} MB` : last ?? '';
}

async function tell(name) {
  if (asking) return;
  asking = true;
  try {
    show(await ask(name));
  } catch ({ message }) {
    Object.assign(says, { className: 'error', textContent: `refused: ${message}` });
  }
  asking = false;
}

button.onclick = () => tell(on ? 'stop' : 'start');
setInterval(() => { if (!section.hidden && says.className !== 'error') tell('state'); }, period);

export function takeRecording(offered) {
  services = offered;
  section.hidden = !offered.has('/drydock/recording/start');
  if (!section.hidden) tell('state');
}
