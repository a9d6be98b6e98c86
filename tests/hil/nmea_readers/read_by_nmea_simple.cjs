// What nmea-simple reads in the sentences on standard input, as JSON: an object for each, in its units.
const { parseNmeaSentence } = require('nmea-simple')

const second = (date) => date.getUTCHours() * 3600 + date.getUTCMinutes() * 60 + date.getUTCSeconds() + date.getUTCMilliseconds() / 1e3
const values = {
  GGA: (m) => ({
    second_of_day: second(m.time), latitude_deg: m.latitude, longitude_deg: m.longitude, altitude_m: m.altitudeMeters,
    separation_m: m.geoidalSeperation, satellites: m.satellitesInView, quality: m.fixType === 'fix' ? 1 : 0
  }),
  RMC: (m) => ({
    utc_s: m.datetime.getTime() / 1e3, latitude_deg: m.latitude, longitude_deg: m.longitude, speed_kn: m.speedKnots, course_deg: m.trackTrue
  }),
  VTG: (m) => ({ speed_kn: m.speedKnots, speed_kmph: m.speedKmph, course_deg: m.trackTrue }),
  GSV: (m) => ({ satellites_in_view: m.satellitesInView }),
  GSA: (m) => ({ fix: m.fixMode === '3D' ? 3 : 0, pdop: m.PDOP }),
  VHW: (m) => ({ speed_kn: m.speedKnots, speed_kmph: m.speedKmph }),
  HDT: (m) => ({ heading_deg: m.heading }),
  HDG: (m) => ({ heading_deg: m.heading, variation_deg: m.variation, variation_to: m.variationDirection }),
  HDM: (m) => ({ heading_deg: m.heading }),
  DBT: (m) => ({ depth_m: m.depthMeters, depth_ft: m.depthFeet, depth_fathoms: m.depthFathoms })
}
const read = []
for (const line of require('fs').readFileSync(0, 'utf8').split('\r\n')) {
  const name = line.slice(3, 6)
  if (name in values) read.push({ sentence: name, ...values[name](parseNmeaSentence(line)) })
}
console.log(JSON.stringify(read))
