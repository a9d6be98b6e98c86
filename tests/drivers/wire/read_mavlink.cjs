// What node-mavlink finds in bytes given as hexadecimal digits: a list of packets as JSON. A NaN is null.
const { MavLinkPacketSplitter, MavLinkPacketParser, minimal, standard, common, ardupilotmega } = require('node-mavlink')

const registry = { ...minimal.REGISTRY, ...standard.REGISTRY, ...common.REGISTRY, ...ardupilotmega.REGISTRY }
const packets = []
const splitter = new MavLinkPacketSplitter()
splitter.pipe(new MavLinkPacketParser()).on('data', ({ header, protocol, payload }) => {
  const kind = registry[header.msgid]
  packets.push({
    name: kind.MSG_NAME, sequence: header.seq, system: header.sysid, component: header.compid,
    data: protocol.data(payload, kind),
  })
}).on('end', () => {
  const seeds = Object.values(registry).map(kind => [kind.MSG_ID, kind.MAGIC_NUMBER, kind.MSG_NAME])
  console.log(JSON.stringify({ packets, seeds }, (_, value) => (typeof value === 'bigint' ? Number(value) : value)))
})
splitter.end(Buffer.from(process.argv[2], 'hex'))
