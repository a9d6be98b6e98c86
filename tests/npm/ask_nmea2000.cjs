// Group functions (PGN 126208) as canboatjs writes them. Standard input: a JSON list of their fields; output: a JSON list of bytes.
const { toPgn } = require('@canboat/canboatjs')

const asked = JSON.parse(require('fs').readFileSync(0, 'utf8'))
console.log(JSON.stringify(asked.map((fields) => [...toPgn({ pgn: 126208, dst: 37, prio: 3, fields })])))
