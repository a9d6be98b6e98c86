"""What pynmea2 reads in the sentences on standard input, as JSON: an object for each, in its units."""

import datetime
import json
import sys

import pynmea2


def time_of(moment):
    return moment.replace(tzinfo=datetime.timezone.utc).timestamp()


def second_of_day(time):
    return time.hour * 3600 + time.minute * 60 + time.second + time.microsecond / 1e6


VALUES = {
    "GGA": lambda m: {"second_of_day": second_of_day(m.timestamp), "latitude_deg": m.latitude,
                      "longitude_deg": m.longitude, "altitude_m": m.altitude, "separation_m": float(m.geo_sep),
                      "satellites": int(m.num_sats), "quality": m.gps_qual},
    "RMC": lambda m: {"utc_s": time_of(m.datetime), "latitude_deg": m.latitude, "longitude_deg": m.longitude,
                      "speed_kn": m.spd_over_grnd, "course_deg": m.true_course},
    "VTG": lambda m: {"speed_kn": m.spd_over_grnd_kts, "speed_kmph": m.spd_over_grnd_kmph, "course_deg": m.true_track},
    "GSV": lambda m: {"satellites_in_view": int(m.num_sv_in_view)},
    "GSA": lambda m: {"fix": int(m.mode_fix_type), "pdop": float(m.pdop)},
    "VBW": lambda m: {"ahead_kn": m.lon_water_spd, "starboard_kn": m.trans_water_spd},
    "VHW": lambda m: {"speed_kn": m.water_speed_knots, "speed_kmph": m.water_speed_km},
    "VLW": lambda m: {"distance_nmi": m.trip_distance},
    "HDT": lambda m: {"heading_deg": m.heading},
    "HDG": lambda m: {"heading_deg": m.heading, "variation_deg": m.variation, "variation_to": m.var_dir},
    "HDM": lambda m: {"heading_deg": m.heading},
    "DPT": lambda m: {"depth_m": m.depth, "offset_m": m.offset},
    "DBT": lambda m: {"depth_m": m.depth_meters, "depth_ft": m.depth_feet, "depth_fathoms": m.depth_fathoms},
    "MTW": lambda m: {"temperature_c": m.temperature},
}

read = []
for line in sys.stdin.read().splitlines():
    name = line[3:6]
    if name in VALUES:  # it does not know THS
        read.append({"sentence": name, **VALUES[name](pynmea2.parse(line, check=True))})
json.dump(read, sys.stdout, default=float)
