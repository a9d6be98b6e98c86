// Decodes ROS 2 messages (plain CDR, little endian) by their ros2msg definition.
const sizes = { bool: 1, byte: 1, uint8: 1, int8: 1, uint16: 2, int16: 2, uint32: 4, int32: 4, float32: 4, uint64: 8, int64: 8, float64: 8 };
const readers = {
  bool: (v, o) => v.getUint8(o) !== 0, byte: (v, o) => v.getUint8(o), uint8: (v, o) => v.getUint8(o), int8: (v, o) => v.getInt8(o),
  uint16: (v, o) => v.getUint16(o, true), int16: (v, o) => v.getInt16(o, true), uint32: (v, o) => v.getUint32(o, true),
  int32: (v, o) => v.getInt32(o, true), float32: (v, o) => v.getFloat32(o, true), float64: (v, o) => v.getFloat64(o, true),
  uint64: (v, o) => Number(v.getBigUint64(o, true)), int64: (v, o) => Number(v.getBigInt64(o, true)),
};

// Parses "type[n] name" lines, then "MSG: package/Type" blocks. A line of 80 '=' precedes each block.
function parseDefinition(schema) {
  const blocks = schema.split(/^={80}\n/m);
  const fields = (lines) => lines.filter(Boolean).map((line) => {
    const [, type, array, size, name] = line.match(/^([\w/]+)(\[(\d*)\])? (\w+)$/);
    return { type, name, array: array !== undefined, size: size ? Number(size) : undefined };
  });
  const types = new Map();
  for (const block of blocks.slice(1)) {
    const [head, ...lines] = block.split('\n');
    types.set(head.slice('MSG: '.length), fields(lines));
  }
  return { fields: fields(blocks[0].split('\n')), types };
}

export function makeDecoder(schema) {
  const { fields: top, types } = parseDefinition(schema);
  const text = new TextDecoder();
  return (view) => {
    let at = 0;
    const body = new DataView(view.buffer, view.byteOffset + 4, view.byteLength - 4);
    const primitive = (type) => {
      const size = sizes[type];
      at = Math.ceil(at / size) * size;
      const value = readers[type](body, at);
      at += size;
      return value;
    };
    const string = () => {
      const length = primitive('uint32');
      const value = text.decode(new Uint8Array(body.buffer, body.byteOffset + at, Math.max(length - 1, 0)));
      at += length;
      return value;
    };
    const one = (type) => (type === 'string' ? string() : type in sizes ? primitive(type) : message(types.get(type)));
    const message = (fields) => {
      const value = {};
      for (const { type, name, array, size } of fields) {
        if (!array) { value[name] = one(type); continue; }
        const count = size ?? primitive('uint32');
        value[name] = Array.from({ length: count }, () => one(type));
      }
      return value;
    };
    return message(top);
  };
}
