// What canboatjs finds in the lines of NMEA 2000 (candump, Actisense, Yacht Devices, iKonvert) on standard input, as JSON: the messages, and how many lines it refuses.
const { FromPgn } = require('@canboat/canboatjs')

const parser = new FromPgn({ returnNulls: true })
const messages = []
let refused = 0
parser.on('error', () => { refused += 1 })
parser.on('pgn', ({ pgn, src, fields }) => messages.push({ pgn, src, fields }))
for (const line of require('fs').readFileSync(0, 'utf8').split('\n')) if (line) parser.parseString(line)
console.log(JSON.stringify({ messages, refused }))
