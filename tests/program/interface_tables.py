# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows of the tables of the interface through scenes, and how well the program agrees with each table.

With --show the figures of docs/validation/interface.md are printed."""

import argparse
import csv
import os
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

REFERENCE = Path(os.environ["ADFRIC_SOURCE"])/"tests/reference"
GAS, BOLTZMANN = 1.380649e-23*6.02214076e23, 1.380649e-23
# a ball whose middle has a given pressure [Pa]; what is at rest of digits in E* and the load
RADIUS, MODULUS = 1e-2, 1e9
# goal of closed forms, and of temperatures
GOAL, WARM_GOAL = 1e-10, 1e-8
DIFFUSIVITY, CONDUCTIVITY = 1e-7, 0.2
HEAT = "&heat conductivity = 0.2, density = 1e3, heat_capacity = 2e3, second_conductivity = 0.0 /\n"
BALL = f"&surface kind = 'paraboloid', radius = {RADIUS} /\n&solid young_modulus = {MODULUS*0.75}, poisson_ratio = 0.5 /\n"


def table(name):
    """The rows of a reference table."""
    with open(REFERENCE/f"{name}.csv", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def off(found, wanted):
    """Difference over the size of what is wanted."""
    return abs(float(found)/float(wanted) - 1)


def numbers_of(words):
    """The numbers of `name=number;...`, each without its unit."""
    pairs = (word.split("=", 1) for word in words.split(";") if "=" in word)
    return {name.strip(): value.split()[0] for name, value in pairs}


def law_of(row):
    """The group of friction of a row, velocity, temperature and pressure, and the unit of its shear stress."""
    law, words = row["law"], row["parameters"]
    given = numbers_of(words)
    v, t, p = row["velocity_m_per_s"], row["temperature_K"] or 300.0, float(row["pressure_Pa"] or 0)
    rest, unit = "", 1.0
    if law == "shear_strength":
        rest = f"shear_strength = {given['shear_strength']}, pressure_factor = {given['pressure_factor']}"
        return f"&friction {rest} /\n", "state = 'sliding'", p, unit
    if law == "power":
        rest = (f"shear_strength = {given['shear_strength']}, reference_velocity = {given['reference_velocity']}, "
                f"velocity_exponent = {given['exponent']}")
    elif law == "activated":
        rest = ", ".join(f"{name} = {value}" for name, value in given.items())
    elif law == "tomlinson":
        # the barrier over kT gives Q, and the rate is that of v over v0
        energy, volume = float(given["barrier/kT"])*GAS*300, 4e-27
        v, t, law = float(given["ramp rate v k/(f0 Fc)"]), 300.0, "activated"
        rest = f"barrier_power = 1.5, attempt_velocity = 1.0, activation_energy = {energy!r}, shear_activation_volume = {volume}"
        unit = float(given["barrier/kT"])*BOLTZMANN*300/volume
    elif law == "bonds":
        v, hazard = float(given["u"])*1e-3, given["hazard"]
        rest = f"bond_strength = 1e5, bond_velocity = 1e-3, rest_ratio = {given['m']}, hazard = '{hazard}'"
        unit = 1e5*(1 + float(given["m"]))
    elif law == "log_gaussian":
        rest = (f"peak_shear_strength = {given.get('peak') or given['peak_shear_strength']}, peak_velocity = {given['peak_velocity']}, "
                f"log_width_factor = {given.get('factor') or given['log_width_factor']}")
        shift = words.split(";")[-1].split()
        if shift[0] == "wlf":
            rest += f", shift = 'wlf', wlf_c1 = {shift[1]}, wlf_c2 = {shift[2]}, reference_temperature = {shift[-2]}"
        else:
            rest += f", shift = 'arrhenius', activation_energy = {shift[1]}, reference_temperature = {shift[-2]}"
    needs = law in ("activated", "log_gaussian")
    return f"&friction law = '{law}', {rest} /\n", f"velocity = {v}" + (f", temperature = {t}" if needs else ""), p, unit


class Tables(Runs):
    def measure_laws(self):
        """Shear stress in the middle of a ball, where the pressure is that of the row; without pressure over the area."""
        for row in table("int_laws"):
            friction, operating, pressure, unit = law_of(row)
            load = np.pi**3*RADIUS**2*pressure**3/(6*MODULUS**2) if pressure > 0 else 1e-6
            found, _ = self.run_scene(BALL + friction + f"&operating {operating}, load = {load!r} /\n"
                                      "&output profiles = .true., r_max = 1e-6, n_r = 2 /\n")
            stress = found["friction_force"]/found["contact_area"]
            if pressure > 0 or row["law"] in ("activated", "shear_strength"):
                stress = found["shear_stress"].ravel()[0]
            if pressure == 0 and "pressure" in row["parameters"]:
                # the middle of the ball has a pressure; its rim has none
                friction = friction.replace("pressure_activation_volume = 2e-28, ", "").replace(", pressure_factor = 0.1", "")
                found, _ = self.run_scene(BALL + friction + f"&operating {operating}, load = {load!r} /\n")
                stress = found["friction_force"]/found["contact_area"]
            yield off(stress/unit, row["tau"])

    def measure_totals(self):
        """Both parts of the friction of a wave over rubber, the area and the sum."""
        period, amplitude = 1e-3, 0.4e-3/(2*np.pi)
        for row in table("int_total_wave_1d"):
            found, model = self.run_scene(
                f"&surface kind = 'wave_1d', period = {period}, amplitude = {amplitude!r} /\n"
                f"&solid young_modulus = 7.5e6, poisson_ratio = 0.5, young_moduli = {(float(row['r']) - 1)*7.5e6!r}, relaxation_times = 1e-4 /\n"
                "&friction law = 'log_gaussian', peak_shear_strength = 3e5, peak_velocity = 0.01, log_width_factor = 0.1, "
                "pressure_factor = 0.05 /\n"
                f"&operating mean_pressure = {row['mean_pressure']}, velocity = {row['velocity_m_per_s']} /\n")
            self.assertEqual(model, "wave_1d")
            yield max(off(found[name], row[name]) for name in (
                "contact_fraction", "hysteretic_friction_stress", "interfacial_friction_stress", "friction_stress"))

    def measure_discs(self):
        """Temperature, shear stress of the coldest and the hottest state of a disc."""
        for row in table("int_fixed_point"):
            if not row["case"].startswith("disc") or row["roots"] != "1" and row["root"] not in ("1", row["roots"]):
                continue
            hot = row["case"] == "disc_mean_hot"
            radius, branch = 1e-3 if hot else 1e-4, "cold" if row["root"] == "1" else "hot"
            found, _ = self.run_scene(
                BALL + f"&friction law = 'log_gaussian', peak_shear_strength = {6.5e6 if hot else 1e6}, peak_velocity = 0.01, log_width_factor = 0.1, "
                "shift = 'wlf', reference_temperature = 293.15, wlf_c1 = 8.86, wlf_c2 = 101.6 /\n"
                + HEAT.replace(" /", f", thermal_branch = '{branch}' /")
                + f"&operating contact_radius = {radius}, velocity = {row['velocity_m_per_s']}, temperature = {row['T0_K']} /\n")
            yield max(off(found["contact_temperature"], row["T_K"]), off(found["friction_force"]/(np.pi*radius**2), row["tau_Pa"]))

    def measure_sources(self):
        """Flash temperatures of a uniform disc and of Hertz's source, in the mean and at most; of a band by a cylinder."""
        for row in table("int_heat_sources"):
            key = {"max": "peak_flash_temperature", "mean": "flash_temperature"}.get(row["quantity"])
            if row["source"] not in ("disc_uniform", "disc_hertz", "hertz", "band_uniform") or key is None:
                continue
            is_band, radius = row["source"] == "band_uniform", 1e-4
            friction = "shear_strength = 0.0, pressure_factor = 0.4" if "hertz" in row["source"] else "shear_strength = 1e5"
            velocity = 2*DIFFUSIVITY*float(row["peclet"])/radius
            body, control = BALL, f"contact_radius = {radius}"
            if is_band:
                body, control = BALL.replace("paraboloid", "cylinder"), f"load = {np.pi/4*MODULUS*radius**2/RADIUS!r}"
            found, _ = self.run_scene(body + f"&friction {friction} /\n" + HEAT + f"&operating {control}, velocity = {velocity!r}, "
                                      "temperature = 300.0 /\n")
            unit = found["friction_force"]/(2*radius if is_band else np.pi*radius**2)*velocity*radius/CONDUCTIVITY
            yield off(found[key]/unit, row["T_over_qa_lambda"])

    def check(self, differences, rows, goal):
        differences = list(differences)
        self.assertEqual(len(differences), rows)
        self.assertLess(max(differences), goal)

    def test_laws(self):
        self.check(self.measure_laws(), 47, GOAL)

    def test_totals(self):
        self.check(self.measure_totals(), 59, GOAL)

    def test_discs(self):
        self.check(self.measure_discs(), 54, WARM_GOAL)

    def test_sources(self):
        self.check(self.measure_sources(), 27, WARM_GOAL)


def show():
    """Print the largest difference from each table."""
    case = Tables("test_laws")
    case.setUp()
    for name, measure in (("int_laws", case.measure_laws), ("int_total_wave_1d", case.measure_totals),
                          ("int_fixed_point", case.measure_discs), ("int_heat_sources", case.measure_sources)):
        differences = list(measure())
        print(f"{name:20} {len(differences):4} rows  {max(differences):.1e}")
    case.doCleanups()


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--show", action="store_true", help="print how well the program agrees with each table, and test nothing")
    if parser.parse_known_args()[0].show:
        show()
    else:
        main()
