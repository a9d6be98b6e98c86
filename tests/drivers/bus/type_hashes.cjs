// Recomputes type hashes of ROS 2 (REP-2016, "RIHS01") from definitions: node type_hashes.cjs <
// {"pkg/msg/Type": text} as JSON.
const crypto = require('crypto');
const ids = { int8: 2, uint8: 3, int16: 4, uint16: 5, int32: 6, uint32: 7, int64: 8, uint64: 9, float32: 10, float64: 11,
  bool: 15, byte: 16, string: 17 };
const fixedArray = 48, unboundedSequence = 144;
const full = (name) => name.replace('/', '/msg/');

function field(line) {
  const [, type, brackets, size, name] = line.match(/^([\w/]+)(\[(\d*)\])? (\w+)$/);
  const kind = brackets === undefined ? 0 : size ? fixedArray : unboundedSequence;
  const nested = type in ids ? '' : full(type);
  return { name, type: { type_id: (ids[type] ?? 1) + kind, capacity: Number(size || 0), string_capacity: 0, nested_type_name: nested } };
}

// The hash is taken of the text that Python's json.dumps writes with its default separators.
const spaced = (value) =>
  Array.isArray(value) ? `[${value.map(spaced).join(', ')}]` :
  typeof value === 'object' ? `{${Object.entries(value).map(([k, v]) => `"${k}": ${spaced(v)}`).join(', ')}}` :
  JSON.stringify(value);

function hash(type, text) {
  const blocks = text.split(/^={80}\nMSG: /m);
  const describe = (name, lines) => ({ type_name: name, fields: lines.filter(Boolean).map(field) });
  const others = blocks.slice(1).map((block) => { const [name, ...lines] = block.split('\n'); return describe(full(name), lines); });
  others.sort((a, b) => (a.type_name < b.type_name ? -1 : 1));
  const description = { type_description: describe(type, blocks[0].split('\n')), referenced_type_descriptions: others };
  return 'RIHS01_' + crypto.createHash('sha256').update(spaced(description)).digest('hex');
}

const definitions = JSON.parse(require('fs').readFileSync(0));
console.log(JSON.stringify(Object.fromEntries(Object.entries(definitions).map(([type, text]) => [type, hash(type, text)]))));
