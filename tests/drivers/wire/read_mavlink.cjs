// What node-mavlink finds in bytes given as hexadecimal digits: a list of packets as JSON. A NaN is null.
const { MavLinkPacketSplitter, MavLinkPacketParser, minimal, common, ardupilotmega } = require('node-mavlink')

const registry = { ...minimal.REGISTRY, ...common.REGISTRY, ...ardupilotmega.REGISTRY }
const packets = []
const splitter = new MavLinkPacketSplitter()
splitter.pipe(new MavLinkPacketParser()).on('data', ({ header, protocol, payload }) => {
  const kind = registry[header.msgid]
  packets.push({
    name: kind.MSG_NAME, sequence: header.seq, system: header.sysid, component: header.compid,
    data: protocol.data(payload, kind),
  })
}).on('end', () => {
  const seeds = [minimal.Heartbeat, common.TimeSync, common.Odometry, ardupilotmega.VisionPositionDelta].map(kind => kind.MAGIC_NUMBER)
  console.log(JSON.stringify({ packets, seeds }, (_, value) => (typeof value === 'bigint' ? Number(value) : value)))
})
splitter.end(Buffer.from(process.argv[2], 'hex'))
