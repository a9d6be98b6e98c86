// Each message that canboatjs finds in the lines on standard input, as a line of JSON.
const { FromPgn } = require('@canboat/canboatjs')

const parser = new FromPgn({ returnNulls: true })
let text = ''
parser.on('error', () => {})
parser.on('pgn', (message) => { text += JSON.stringify(message) + '\n' })
for (const line of require('fs').readFileSync(0, 'utf8').split('\n')) if (line) parser.parseString(line)
process.stdout.write(text)
