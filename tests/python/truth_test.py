#!/usr/bin/env python3
"""The truth of a mission, against closed forms."""

import math
import unittest

import numpy as np

import drydock
from tree import ROOT

MISSIONS = ROOT / "rig_config/missions"
A, F = 6378137.0, 1 / 298.257223563  # WGS-84
E2 = F * (2 - F)


def meridian_arc_m(from_deg, to_deg):
    """Along the ellipsoid's meridian, by Simpson's rule over its radius of curvature."""
    latitudes = np.radians(np.linspace(from_deg, to_deg, 2001))
    radii = A * (1 - E2) / (1 - E2 * np.sin(latitudes) ** 2) ** 1.5
    step = latitudes[1] - latitudes[0]
    return step / 3 * (radii[0] + radii[-1] + 4 * radii[1:-1:2].sum() + 2 * radii[2:-1:2].sum())


class Truth(unittest.TestCase):
    def test_a_straight_leg_north_is_an_arc_of_the_meridian(self):
        times = np.array([0.0, 7.25, 30.0])
        table = drydock.truth(MISSIONS / "leveling-straight.toml", times)  # 10 m/s north at 10 m depth
        for row, t in enumerate(times):
            # At depth the arc is shorter than on the ellipsoid by (M - 10 m) / M: 16 parts in ten million.
            self.assertAlmostEqual(meridian_arc_m(36, table["latitude_deg"][row]), 10 * t, delta=1e-4 + 2e-6 * 10 * t)
        np.testing.assert_allclose(table["longitude_deg"], 129, atol=1e-12)
        np.testing.assert_allclose(table["height_m"], -10, atol=1e-9)
        np.testing.assert_allclose(table["velocity_body_mps"], [[10, 0, 0]] * 3, atol=1e-9)

    def test_the_specific_force_is_gravity_and_the_turn_of_the_earth_beneath(self):
        table = drydock.truth(MISSIONS / "leveling-straight.toml", [15.0])
        latitude = math.radians(table["latitude_deg"][0])
        # Somigliana's formula, with the free-air gradient for 10 m of depth; and v^2/M + nothing of Coriolis for a way north.
        gravity = 9.7803253359 * (1 + 0.00193185265241 * math.sin(latitude) ** 2) / math.sqrt(1 - E2 * math.sin(latitude) ** 2)
        gravity += 3.086e-6 * 10
        radius = A * (1 - E2) / (1 - E2 * math.sin(latitude) ** 2) ** 1.5
        self.assertAlmostEqual(table["specific_force_mps2"][0, 2], -(gravity - 100 / radius), delta=1e-5)

    def test_without_times_it_is_one_lap(self):
        table = drydock.truth(MISSIONS / "leveling-straight.toml", every_s=0.5, start_ns=10**18)
        self.assertEqual(table["at_ns"].tolist(), [10**18 + k * 500_000_000 for k in range(61)])

    def test_no_times_give_the_columns_without_rows(self):
        none, one = (drydock.truth(MISSIONS / "s-path.toml", times) for times in ([], [0.0]))
        self.assertEqual(list(none), list(one))
        for name in one:
            self.assertEqual(none[name].shape, (0,) + one[name].shape[1:])
            self.assertEqual(none[name].dtype, one[name].dtype)

    def test_the_order_of_the_times_does_not_matter(self):
        times = np.linspace(0, 60, 200)
        forward, back = (drydock.truth(MISSIONS / "s-path.toml", t) for t in (times, times[::-1]))
        for name in forward:
            np.testing.assert_array_equal(forward[name], back[name][::-1])

    def test_a_wrong_call_says_what_is_allowed(self):
        with self.assertRaisesRegex(ValueError, "another program steers"):
            drydock.truth(MISSIONS / "ardusub.toml", [0.0])
        with self.assertRaisesRegex(ValueError, "nan"):
            drydock.truth(MISSIONS / "s-path.toml", [0.0, math.nan])
        for step in (0, 1e-12, 1e-320):
            with self.assertRaisesRegex(ValueError, "every_s"):
                drydock.truth(MISSIONS / "s-path.toml", every_s=step)
        with self.assertRaisesRegex(ValueError, "times_s has 2 dimensions"):
            drydock.truth(MISSIONS / "s-path.toml", [[0.0, 1.0], [2.0, 3.0]])
        with self.assertRaisesRegex(RuntimeError, "no-such.toml"):
            drydock.truth("no-such.toml", [0.0])


if __name__ == "__main__":
    unittest.main()
