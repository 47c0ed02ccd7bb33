# SPDX-License-Identifier: GPL-3.0-or-later
"""Heat of single contacts that slide, through the program: tables, limits, the energy balance, units, both directions, refusals."""

import csv
import os
import re
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

REFERENCE = Path(os.environ["ADFRIC_SOURCE"])/"tests/reference"
# conductivity 0.2 W/m/K and diffusivity 1e-7 m^2/s, as the tables have them
CONDUCTIVITY, DIFFUSIVITY = 0.2, 1e-7
HEAT = "&heat conductivity = 0.2, density = 1e3, heat_capacity = 2e3, second_conductivity = 0.0 /\n"
SOLID = "&solid young_modulus = 1e8, poisson_ratio = 0.5 /\n"
BALL = "&surface kind = 'paraboloid', radius = 1e-2 /\n" + SOLID
CYLINDER = "&surface kind = 'cylinder', radius = 1e-2 /\n" + SOLID
LAW = ("&friction law = 'log_gaussian', peak_shear_strength = {}, peak_velocity = 0.01, log_width_factor = 0.1, shift = 'wlf', "
       "reference_temperature = 293.15, wlf_c1 = 8.86, wlf_c2 = 101.6 /\n")


def table(name):
    """The rows of a reference table."""
    with open(REFERENCE/f"{name}.csv", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Heat(Runs):
    def test_fixed_points(self):
        """Every row of discs: the coldest and the hottest temperature of a contact of a given radius, its shear stress, its gain."""
        rows = [row for row in table("int_fixed_point") if row["case"].startswith("disc")]
        self.assertGreater(len(rows), 45)
        for row in rows:
            hot = row["case"] == "disc_mean_hot"
            if row["roots"] != "1" and row["root"] not in ("1", row["roots"]):
                continue
            radius = 1e-3 if hot else 1e-4
            branch = "cold" if row["root"] == "1" else "hot"
            found, model = self.run_scene(
                BALL + LAW.format(6.5e6 if hot else 1e6) + HEAT.replace(" /", f", thermal_branch = '{branch}' /")
                + f"&operating contact_radius = {radius}, velocity = {row['velocity_m_per_s']}, temperature = {row['T0_K']} /\n")
            self.assertEqual(model, "indenter")
            area = np.pi*radius**2
            np.testing.assert_allclose(found["contact_temperature"], float(row["T_K"]), atol=1e-8, rtol=0)
            np.testing.assert_allclose(found["friction_force"]/area, float(row["tau_Pa"]), rtol=1e-8)
            np.testing.assert_allclose(found["thermal_gain"], float(row["gain"]), rtol=1e-5, atol=1e-8)
            self.assertEqual(found["heat_share"], 1)
            np.testing.assert_allclose(found["interface_heat"], found["friction_force"]*float(row["velocity_m_per_s"]), rtol=1e-12)
            self.assertNotIn("bulk_heat", found)
            self.assertNotIn("velocity_slope", found)

    def test_sources(self):
        """Flash temperatures of a constant shear stress and of one that goes with Hertz's pressure, against the table of sources."""
        radius, n = 1e-4, 0
        for row in table("int_heat_sources"):
            key = {"max": "peak_flash_temperature", "mean": "flash_temperature"}.get(row["quantity"])
            if row["source"] not in ("disc_uniform", "disc_hertz") or key is None:
                continue
            friction = "shear_strength = 1e5" if row["source"] == "disc_uniform" else "shear_strength = 0.0, pressure_factor = 0.4"
            velocity = 2*DIFFUSIVITY*float(row["peclet"])/radius
            found, _ = self.run_scene(BALL + f"&friction {friction} /\n" + HEAT + f"&operating contact_radius = {radius}, "
                                      f"velocity = {velocity:.17g}, temperature = 300.0 /\n")
            unit = found["friction_force"]/(np.pi*radius**2)*velocity*radius/CONDUCTIVITY
            np.testing.assert_allclose(found[key]/unit, float(row["T_over_qa_lambda"]), rtol=1e-8)
            n += 1
        self.assertGreater(n, 12)

    def test_both_sources(self):
        """A shear strength and a part that goes with the pressure add up in the mean; the largest lies between bounds."""
        operating = "&operating load = 1e-2, velocity = 0.05, temperature = 300.0 /\n"
        found = [self.run_scene(BALL + f"&friction {friction} /\n" + HEAT + operating)[0] for friction in (
            "shear_strength = 1e5", "shear_strength = 0.0, pressure_factor = 0.4", "shear_strength = 1e5, pressure_factor = 0.4")]
        np.testing.assert_allclose(found[2]["flash_temperature"], found[0]["flash_temperature"] + found[1]["flash_temperature"],
                                   rtol=1e-10)
        peaks = [one["peak_flash_temperature"] for one in found]
        self.assertLess(peaks[2], peaks[0] + peaks[1])
        self.assertGreater(peaks[2], max(peaks[0], peaks[1]))

    def test_shapes(self):
        """The heat of a uniform shear stress asks for the area alone: other bodies, and adhesion, with the area of friction."""
        bodies = (BALL, "&surface kind = 'cone', slope = 0.1 /\n" + SOLID, "&surface kind = 'flat_punch', face_radius = 2e-4 /\n" + SOLID,
                  BALL + "&adhesion work_of_adhesion = 0.05 /\n",
                  BALL + "&adhesion work_of_adhesion = 0.05, adhesion_stress = 1e5 /\n")
        for body in bodies:
            rest = LAW.format(6.5e6) + HEAT + "&operating load = 1e-2, velocity = {}, temperature = 283.15 /\n"
            found, _ = self.run_scene(body + rest.format(0.02))
            radius = np.sqrt(found["friction_area"]/np.pi)
            same, _ = self.run_scene(BALL + rest.format(0.02).replace("load = 1e-2", f"contact_radius = {radius:.17g}"))
            for key in ("contact_temperature", "flash_temperature", "peak_flash_temperature", "thermal_gain", "interface_heat"):
                np.testing.assert_allclose(found[key], same[key], rtol=1e-9, err_msg=key)
            back, _ = self.run_scene(body + rest.format(-0.02))
            for key in found:
                sign = -1 if key in ("friction_force", "friction_coefficient", "velocity") else 1
                np.testing.assert_allclose(back[key], sign*found[key], rtol=1e-13, err_msg=key)
            # a length of 1 is now 1000; velocities and heat per area keep the number of Peclet
            large = re.sub(r"(radius) = ([\d.e-]+)", lambda one: f"{one[1]} = {float(one[2])*1e3!r}", body)
            large = large.replace("adhesion = 0.05", "adhesion = 50.0")
            scaled, _ = self.run_scene(large + rest.format(0.02).replace("1e-2", "1e4").replace("conductivity = 0.2", "conductivity = 200.0"))
            np.testing.assert_allclose(scaled["contact_temperature"], found["contact_temperature"], rtol=1e-9)

    def test_cold_and_at_rest(self):
        """Without a change of the law by heat the friction is that without heat; at rest nothing is warm; apart nothing rubs."""
        rest = "&friction law = 'power', shear_strength = 1e6, reference_velocity = 1.0, velocity_exponent = 0.2 /\n"
        operating = "&operating load = 1e-2, velocity = 0.02{} /\n"
        warm, _ = self.run_scene(BALL + rest + HEAT + operating.format(", temperature = 300.0"))
        plain, _ = self.run_scene(BALL + rest + operating.format(""))
        np.testing.assert_allclose(warm["friction_force"], plain["friction_force"], rtol=1e-14)
        self.assertGreater(warm["flash_temperature"], 0)
        self.assertGreater(warm["peak_flash_temperature"], warm["flash_temperature"])
        still, _ = self.run_scene(BALL + rest + HEAT + operating.format(", temperature = 300.0").replace("0.02", "0.0"))
        self.assertEqual(still["contact_temperature"], 300)
        self.assertEqual(still["flash_temperature"], 0)
        apart, _ = self.run_scene(BALL + rest + HEAT + operating.format(", temperature = 300.0").replace("1e-2", "0.0"))
        self.assertEqual(apart["interface_heat"], 0)
        self.assertTrue(np.isnan(apart["contact_temperature"]))

    def test_cylinder_sources(self):
        """The largest flash of a band of constant shear stress on an elastic solid, against the table."""
        n = 0
        for row in table("int_heat_sources"):
            if row["source"] != "band_uniform" or row["quantity"] != "max":
                continue
            first, _ = self.run_scene(CYLINDER + "&friction shear_strength = 1e5 /\n&operating load = 10.0, velocity = 1.0 /\n")
            half_width = float(first["contact_half_width"])
            velocity = 2*DIFFUSIVITY*float(row["peclet"])/half_width
            found, model = self.run_scene(CYLINDER + "&friction shear_strength = 1e5 /\n" + HEAT
                                          + f"&operating load = 10.0, velocity = {velocity:.17g}, temperature = 300.0 /\n")
            self.assertEqual(model, "hertz")
            np.testing.assert_allclose(found["peak_flash_temperature"], 1e5*velocity*half_width/CONDUCTIVITY*float(row["T_over_qa_lambda"]),
                                       rtol=1e-8)
            np.testing.assert_allclose(found["interface_heat"], found["friction_force"]*velocity, rtol=1e-12)
            self.assertEqual(found["bulk_heat"], 0)
            n += 1
        self.assertEqual(n, 9)

    def test_cylinder(self):
        """A cylinder on an elastic solid: as on a solid that has relaxed, its own fixed point, both directions, and other units."""
        operating = "&operating load = 10.0, velocity = 0.05, temperature = 283.15 /\n"
        for friction in (LAW.format(2e6), "&friction shear_strength = 1e5, pressure_factor = 0.4 /\n"):
            found, _ = self.run_scene(CYLINDER + friction + HEAT + operating)
            relaxed, _ = self.run_scene(CYLINDER.replace("0.5 /", "0.5, young_moduli = 1e8, relaxation_times = 1e-12 /")
                                        + friction + HEAT + operating)
            for key in ("contact_temperature", "flash_temperature", "peak_flash_temperature", "interface_heat", "friction_force"):
                np.testing.assert_allclose(found[key], relaxed[key], rtol=1e-6, err_msg=key)
            back, _ = self.run_scene(CYLINDER + friction + HEAT + operating.replace("0.05", "-0.05"))
            for key in found:
                signed = key in ("friction_force", "friction_coefficient", "interfacial_friction_force", "velocity")
                np.testing.assert_allclose(back[key], -found[key] if signed else found[key], rtol=1e-12, err_msg=key)
            large, _ = self.run_scene(CYLINDER.replace("1e-2", "1e1") + friction + HEAT.replace("= 0.2", "= 200.0")
                                      + operating.replace("10.0", "1e4"))
            np.testing.assert_allclose(large["contact_temperature"], found["contact_temperature"], rtol=1e-10)
        unit, _ = self.run_scene(CYLINDER + "&friction shear_strength = 1e6 /\n" + HEAT + operating)
        found, _ = self.run_scene(CYLINDER + LAW.format(2e6) + HEAT + operating)
        strength = found["friction_force"]/(2*found["contact_half_width"])
        warm, shift = found["contact_temperature"], lambda t: -8.86*(t - 293.15)/(101.6 + t - 293.15)
        np.testing.assert_allclose(warm, 283.15 + unit["flash_temperature"]*strength/1e6, rtol=1e-12)
        np.testing.assert_allclose(strength, 2e6*np.exp(-0.1*(np.log10(5.0) + shift(warm))**2), rtol=1e-10)

    def test_heat_of_coulomb(self):
        """A shear stress that goes with the pressure cycles the solid: of a line mu^2 of the losses by the pressure, of directions
        what the proof of each wave says. With what the interface takes it is the work of the friction."""
        mu, velocity = 0.8, 0.02
        friction = f"&friction shear_strength = 0.0, pressure_factor = {mu} /\n"
        solid = "&solid young_modulus = 1e8, poisson_ratio = {}, young_moduli = 9e8, relaxation_times = 1e-2 /\n"
        period, amplitude = 1e-3, 1e-5
        wave = f"&surface kind = 'wave_{{}}d', period = {period}, amplitude = {amplitude} /\n&numerics cells = 128 /\n"
        operating = f"&operating mean_pressure = {{}}, velocity = {velocity}, temperature = 300.0{{}} /\n"
        for nu in (0.5, 0.3):
            scene = wave.format(1) + solid.format(nu) + friction + HEAT
            found, _ = self.run_scene(scene + operating.format(2e6, ""))
            np.testing.assert_allclose(found["bulk_heat"], (1 + mu**2)*velocity*found["dissipation"], rtol=1e-6)
            np.testing.assert_allclose(found["bulk_heat"] + found["interface_heat"], velocity*found["friction_stress"], rtol=1e-12)
            # both waves at 45 degrees, in full contact, within the square of the cells over the wave
            turned, _ = self.run_scene(wave.format(2).replace("128", "512") + solid.format(nu) + friction + HEAT
                                       + operating.format(2e9, f", direction = {np.pi/4:.17g}"))
            factor = 1 + mu**2*(1 - nu/2)/(1 - nu)
            np.testing.assert_allclose(turned["bulk_heat"], factor*velocity*turned["hysteretic_friction_stress"],
                                       rtol=(2*np.pi/512)**2/8)
            np.testing.assert_allclose(turned["bulk_heat"] + turned["interface_heat"], velocity*turned["friction_stress"], rtol=1e-12)
            roller, _ = self.run_scene("&surface kind = 'cylinder', radius = 1e-2 /\n" + solid.format(nu) + friction + HEAT
                                       + f"&operating load = 1e2, velocity = {velocity}, temperature = 300.0 /\n")
            np.testing.assert_allclose(roller["bulk_heat"], (1 + mu**2)*velocity*roller["hysteretic_friction_force"], rtol=1e-10)
            np.testing.assert_allclose(roller["bulk_heat"] + roller["interface_heat"], velocity*roller["friction_force"], rtol=1e-10)
        # another shear stress keeps the losses by the pressure
        other, _ = self.run_scene(scene.replace("shear_strength = 0.0", "shear_strength = 1e5") + operating.format(2e6, ""))
        np.testing.assert_allclose(other["bulk_heat"], velocity*other["hysteretic_friction_stress"], rtol=1e-12)

    def test_profile(self):
        """The shear stress of the profile is that of the contact's own temperature."""
        found, _ = self.run_scene(BALL + LAW.format(6.5e6) + HEAT + "&operating load = 1e-2, velocity = 0.02, temperature = 283.15 /\n"
                                  "&output profiles = .true., r_max = 1e-5, n_r = 3 /\n")
        np.testing.assert_allclose(found["shear_stress"].ravel(), found["friction_force"]/found["friction_area"], rtol=1e-12)

    def test_check(self):
        """`check` says from which velocity on heat matters."""
        self.write("&job output = 'run.h5' /\n" + BALL + LAW.format(6.5e6) + HEAT
                   + "&operating load = 1e-2, velocity = 0.02, temperature = 283.15 /\n")
        page, _ = self.run_program("check", "run.nml")
        self.assertIn("heat changes the shear stress by a hundredth from a velocity of", page)

    def test_refused(self):
        """One line, status 2."""
        law, operating = LAW.format(1e6), "&operating load = 1e-2, velocity = 0.02, temperature = 283.15 /\n"
        cone = "&surface kind = 'cone', slope = 0.1 /\n" + SOLID
        constant = "&friction shear_strength = 1e5, pressure_factor = 0.4 /\n"
        adhesion = "&adhesion work_of_adhesion = 0.05 /\n"
        for text, message in (
                (BALL + law + HEAT.replace("heat_capacity = 2e3, ", "") + operating, "&heat heat_capacity: is missing"),
                (BALL + law + HEAT.replace("second_conductivity = 0.0", "second_conductivity = 1.0") + operating, "how a single contact shares"),
                (BALL + law + HEAT.replace(" /", ", background = 'time', sliding_time = 1.0 /") + operating, "no nominal area"),
                (cone + constant + HEAT + operating, "for a paraboloid without adhesion alone"),
                (BALL + adhesion + law.replace(" /", ", interaction = 0.5 /") + HEAT + operating, "depend on its own temperature"),
                (BALL + constant + HEAT + operating.replace("velocity = 0.02, ", "state = 'sliding', "), "&operating velocity: is missing"),
                (BALL + law + HEAT + operating.replace(", temperature = 283.15", ""), "temperature"),
                (CYLINDER.replace("0.5", "0.3") + constant.replace(" /", ", coupling = .true. /") + HEAT + operating,
                 "depend on its own temperature"),
                (CYLINDER + constant + HEAT + operating.replace("velocity = 0.02, ", "state = 'sliding', "), "velocity"),
                ("&surface kind = 'wave_1d', period = 1e-3, amplitude = 1e-5 /\n&solid extent = 'foundation', stiffness = 1e11, "
                 "stiffnesses = 9e11, relaxation_times = 1e-3 /\n&friction shear_strength = 1e5 /\n" + HEAT
                 + "&operating mean_pressure = 1e5, velocity = 0.1 /\n", "of which columns know nothing; extent = 'layer'"),
                (BALL + HEAT + operating, "nothing solves")):
            with self.subTest(text=text):
                self.write("&job output = 'run.h5' /\n" + text)
                _, errors = self.run_program("run", "--quiet", "--force", "run.nml", status=2)
                self.assertIn(message, errors)
                self.assertEqual(errors.count("\n"), 1, errors)


if __name__ == "__main__":
    main()
