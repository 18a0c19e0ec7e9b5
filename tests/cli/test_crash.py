# SPDX-License-Identifier: GPL-3.0-or-later
"""Cars that were cooked from files and driven into a pole at 15 m/s stay dented, keep their locks and are whole."""
import unittest

import program

try:
    import crash
except ImportError:
    crash = None


@unittest.skipUnless(crash, "no h5py or no numpy")
class Crash(program.Case):
    def crashed(self, cook):
        result = crash.crash(cook(self.folder), "--no-series")
        self.assertTrue(result["is_at_rest"])
        self.assertGreater(result["dent_m"], 0.1)
        self.assertLess(result["dent_m"], 1)
        self.assertGreater(result["dent_m"], 0.6 * result["deepest_m"], "it springs back")
        self.assertLess(result["locked_drift"], 1e-6)
        self.assertEqual(result["inside_out"], 0)
        return result

    def test_the_sample_car(self):
        self.assertGreater(len(self.crashed(crash.cook_car)["locked_at"]), 100)

    @program.needs_data
    def test_a_car_of_others_with_an_engine_block_of_ours(self):
        locked = self.crashed(crash.cook_suv)["locked_at"]
        self.assertEqual(len(locked), crash.ENGINE_VERTICES)
        self.assertTrue((abs(locked.min(axis=0) - crash.ENGINE_LOW) < 1e-6).all())
        self.assertTrue((abs(locked.max(axis=0) - crash.ENGINE_HIGH) < 1e-6).all())


if __name__ == "__main__":
    unittest.main()
