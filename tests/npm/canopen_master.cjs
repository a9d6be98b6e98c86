// A master of another maker (npm's `canopen`) against one node, whose number is 1. Arguments: its electronic data sheet, and
// what the master does. Standard output: frames as `601#4000100000000000`, `wait` for a second of the bus, at last `end` with
// JSON. Standard input: the frames that it hears, and `waited`.
const Module = require('module');
// Its CRC is native code that `npm ci --ignore-scripts` does not build. Only transfers in blocks have one.
const load = Module._load;
Module._load = (name, ...rest) => (name === 'node-crc' ? { crc: () => Buffer.alloc(2) } : load(name, ...rest));
const { Device, DataType, AccessType, Eds } = require('canopen');

const [sheet, task] = process.argv.slice(2);
const node = 1;
const patience = 20000;
const device = new Device({ id: 10 });
device.on('message', ({ id, data }) => {
  console.log(id.toString(16).toUpperCase().padStart(3, '0') + '#' + data.toString('hex').toUpperCase());
});

let waited = null;
require('readline').createInterface({ input: process.stdin }).on('line', (line) => {
  if (line === 'waited') return waited();
  const [id, data] = line.split('#');
  const bytes = Buffer.from(data, 'hex');
  device.receive({ id: parseInt(id, 16), data: bytes, len: bytes.length });
});
const wait = () => new Promise((resolve) => { waited = resolve; console.log('wait'); });

const upload = (index, subIndex, options = {}) =>
  device.sdo.upload({ deviceId: node, index, subIndex, timeout: patience, ...options })
    .catch((error) => 'refused ' + error.code.toString(16));
const write = (index, subIndex, data, dataType) =>
  device.sdo.download({ deviceId: node, index, subIndex, data, dataType, timeout: patience })
    .then(() => 'written', (error) => 'refused ' + error.code.toString(16));

// Every variable of the sheet: what the node says, and what the sheet says.
async function readAll(eds) {
  const all = {};
  for (const [index, entry] of eds.entries()) {
    for (let sub = 0; sub <= (entry.subNumber ? 254 : 0); ++sub) {
      const variable = entry.subNumber ? entry.at(sub) : entry;
      if (!variable) continue;
      const said = await upload(parseInt(index, 16), sub, { dataType: variable.dataType });
      all[index + ':' + sub] = [said, variable.value];
    }
  }
  return all;
}

// TPDO1 at another number with the status before the process value, as REAL32.
async function remap() {
  const { UNSIGNED8, UNSIGNED32 } = DataType;
  const answers = [];
  const set = async (...what) => answers.push(await write(...what));
  await set(0x1800, 1, 0x80000181, UNSIGNED32);
  await set(0x1A00, 0, 0, UNSIGNED8);
  await set(0x1A00, 1, 0x61500108, UNSIGNED32);
  await set(0x1A00, 2, 0x61300120, UNSIGNED32);
  await set(0x1A00, 3, 0x61310120, UNSIGNED32);
  await set(0x1A00, 0, 2, UNSIGNED8);
  await set(0x1800, 1, 0x2C1, UNSIGNED32);
  const status = device.eds.addEntry(0x2000, { parameterName: 'status', dataType: UNSIGNED8, accessType: AccessType.READ_WRITE });
  const value = device.eds.addEntry(0x2001, { parameterName: 'value', dataType: DataType.REAL32, accessType: AccessType.READ_WRITE });
  device.eds.addReceivePdo({ cobId: 0x2C1, dataObjects: [status, value] });
  let received = 0;
  device.pdo.on('pdo', () => ++received);
  device.nmt.startNode(node);
  await wait();
  return { answers, received, status: status.value, value: value.value,
           read: await upload(0x6130, 1, { dataType: DataType.REAL32 }) };
}

// Reads and writes that a node refuses.
async function provoke() {
  return {
    object: await upload(0x1234, 0),
    subindex: await upload(0x1018, 9),
    readOnly: await write(0x1000, 0, 1, DataType.UNSIGNED32),
    length: await write(0x1017, 0, 1, DataType.UNSIGNED32),
    signature: await write(0x1010, 1, Buffer.from('evas')),
    saved: await write(0x1010, 1, Buffer.from('save')),
    blocks: await upload(0x1008, 0, { blockTransfer: true }),
    long: await write(0x1017, 0, Buffer.from('much too long')),
  };
}

async function main() {
  const eds = Eds.fromFile(sheet);
  device.eds.addSdoClientParameter(node, 0x600 + node, 0x580 + node);
  device.start();
  device.nmt.startNode();  // itself
  const done = task === 'read' ? await readAll(eds) : task === 'remap' ? await remap() : await provoke();
  console.log('end ' + JSON.stringify(done));
  process.exit(0);
}
main().catch((error) => { console.log('end ' + JSON.stringify({ error: String(error.stack) })); process.exit(1); });
