# SPDX-License-Identifier: GPL-3.0-or-later
"""Shear stress that moves the contact, through the program: the tables, both directions, units, what is left out, and refusals."""

import csv
import os
import re
import sys
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

REFERENCE = Path(os.environ["ADFRIC_SOURCE"])/"tests/reference"
# the wave of these scenes, and its contact modulus: E* k D is 2 pi 1e7 Pa
PERIOD, AMPLITUDE, MODULUS = 1e-3, 1e-5, 1e9
SLOPE = 2*np.pi*AMPLITUDE/PERIOD
WAVE = f"&surface kind = 'wave_1d', period = {PERIOD}, amplitude = {AMPLITUDE} /\n"
FRICTION = "&friction shear_strength = 0.0, pressure_factor = {}, coupling = .true. /\n"
# scenes with a coupling, of every solver
SCENES = {
    "wave_1d": WAVE + "&solid young_modulus = 1e9, poisson_ratio = 0.2 /\n&operating mean_pressure = 1e7, velocity = 0.01 /\n",
    "hertz": "&surface kind = 'cylinder', radius = 1e-3 /\n&solid young_modulus = 1e9, poisson_ratio = 0.2 /\n"
             "&operating load = 1e3, velocity = 0.01 /\n",
    "surface_sliding": WAVE.replace("wave_1d", "wave_2d") + "&solid young_modulus = 1e9, poisson_ratio = 0.2 /\n"
                       "&operating mean_pressure = 1e7, velocity = 0.01 /\n&numerics cells = 64 /\n",
    "relaxing": WAVE + "&solid young_modulus = 1e8, poisson_ratio = 0.2, young_moduli = 9e8, relaxation_times = 1e-2 /\n"
                "&operating mean_pressure = 4e6, velocity = 0.01 /\n&numerics cells = 512 /\n",
    "layer": WAVE + "&solid young_modulus = 1e9, poisson_ratio = 0.4, extent = 'layer', thickness = 1e-4, base = 'bonded' /\n"
             "&operating mean_pressure = 1e7, velocity = 0.01 /\n&numerics cells = 512 /\n"}
PUNCH = "&surface {} /\n&solid poisson_ratio = 0.3, young_modulus = 1e9 /\n&operating load = 1e4, velocity = 0.01 /\n"


def table(name):
    """The rows of a reference table."""
    with open(REFERENCE/f"{name}.csv", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def solid(nu):
    return f"&solid young_modulus = {MODULUS*(1 - nu**2):.17g}, poisson_ratio = {nu:.17g} /\n"


class Coupling(Runs):
    def test_waves(self):
        """Every row of waves, under a mean pressure and at the penetration that belongs to it."""
        rows = [row for row in table("int_coupling") if row["case"] == "wave_1d"]
        self.assertEqual(len(rows), 21)
        unit = MODULUS*SLOPE
        for mu, nu in sorted({(float(row["mu"]), float(row["nu"])) for row in rows}):
            some = [row for row in rows if (float(row["mu"]), float(row["nu"])) == (mu, nu)]
            values = {name: np.array([float(row[name]) for row in some])
                      for name in ("contact_fraction", "centre_m", "mean_pressure_or_load", "slope_friction_T_s")}
            scene = WAVE + solid(nu) + FRICTION.format(mu) + "&operating velocity = 1e-3 /\n"
            loads = ", ".join(f"{q*unit:.17g}" for q in values["mean_pressure_or_load"])
            found, model = self.run_scene(scene + f"&sweep variable = 'mean_pressure', values = {loads} /\n")
            self.assertEqual(model, "wave_1d")
            depths = ", ".join(f"{depth:.17g}" for depth in found["penetration"])
            again, _ = self.run_scene(scene + f"&sweep variable = 'penetration', values = {depths} /\n")
            for results, accuracy in ((found, 1e-11), (again, 1e-6)):
                np.testing.assert_allclose(results["contact_fraction"], values["contact_fraction"], rtol=accuracy)
                np.testing.assert_allclose(results["contact_shift"], values["centre_m"]*PERIOD/(2*np.pi), rtol=accuracy)
                force = values["slope_friction_T_s"]*unit*SLOPE
                np.testing.assert_allclose(results["hysteretic_friction_stress"], force, rtol=accuracy)
                np.testing.assert_allclose(results["friction_stress"], force + mu*values["mean_pressure_or_load"]*unit, rtol=accuracy)

    def test_cylinders(self):
        """Every row of cylinders, also with a constant shear stress."""
        rows = [row for row in table("int_coupling") if row["case"].startswith("cylinder")]
        self.assertEqual(len(rows), 7)
        for row in rows:
            nu, mu, tau = (float(row[name] or 0) for name in ("nu", "mu", "tau_over_Estar"))
            friction = FRICTION.format(mu).replace("shear_strength = 0.0", f"shear_strength = {tau*MODULUS}")
            load = float(row["mean_pressure_or_load"])*MODULUS
            found, model = self.run_scene("&surface kind = 'cylinder', radius = 1.0 /\n" + solid(nu) + friction
                                          + f"&operating load = {load:.17g}, velocity = 1e-3 /\n")
            self.assertEqual(model, "hertz")
            self.assertAlmostEqual(float(found["contact_half_width"]), 0.1, delta=1e-13)
            np.testing.assert_allclose(found["contact_shift"], float(row["centre_m"]), rtol=1e-12)
            np.testing.assert_allclose(found["hysteretic_friction_force"], float(row["slope_friction_T_s"])*MODULUS, rtol=1e-12)
            np.testing.assert_allclose(found["interfacial_friction_force"], mu*load + 0.2*tau*MODULUS, rtol=1e-12)

    def test_punches(self):
        """Every row of flat punches and wedges: load, middle of the contact, force on the slopes, and the pressure at a position."""
        rows = [row for row in table("int_coupling") if row["case"].startswith(("flat", "wedge"))]
        self.assertEqual(len(rows), 4)
        for row in rows:
            nu, mu, x = (float(row[name]) for name in ("nu", "mu", "pressure_point_x"))
            flat = row["case"].startswith("flat")
            unit = MODULUS if not flat else 1.0
            load = float(row["mean_pressure_or_load"])*unit
            body = "kind = 'line_punch', face_half_width = 1.0" if flat else "kind = 'wedge', slope = 0.1"
            scene = (f"&surface {body} /\n" + solid(nu) + FRICTION.format(mu) + "&operating load = {:.17g}, velocity = {} /\n"
                     f"&output profiles = .true., x_min = {-(x or 1)}, x_max = {x or 1}, n_x = 3 /\n")
            # the table checks loads and forces of wedges by an identity, which says how far they are off; positions have all digits
            accuracy = max(1e-12, 2*float(row["check"])) if not flat else 1e-12
            if not flat:
                scene = scene.replace("load = {:.17g}", "contact_half_width = {}")
            for velocity in (1e-3, -1e-3):
                found, model = self.run_scene(scene.format(load if flat else 1.0, velocity))
                self.assertEqual(model, "rigid_punch")
                sign = np.sign(velocity)
                pressure = found["pressure"].ravel()[1 if x == 0 else 2 if sign > 0 else 0]
                np.testing.assert_allclose(pressure, float(row["pressure_there"])*unit, rtol=1e-12)
                force = 0 if flat else float(row["slope_friction_T_s"])*unit
                np.testing.assert_allclose(found["load"], load, rtol=accuracy)
                np.testing.assert_allclose(found["hysteretic_friction_force"], sign*force, rtol=accuracy)
                np.testing.assert_allclose(found["friction_force"], sign*(mu*load + force), rtol=accuracy)
                if flat:
                    continue
                np.testing.assert_allclose(found["contact_shift"], sign*float(row["centre_m"]), rtol=1e-12)
                self.assertLess(abs(found["energy_imbalance"]), 1e-10)
            if not flat:
                # the same contact under its load
                again, _ = self.run_scene(scene.format(1.0, -1e-3).replace("contact_half_width = 1.0", f"load = {found['load']:.17g}"))
                np.testing.assert_allclose(again["contact_half_width"], 1.0, rtol=1e-12)
                np.testing.assert_allclose(again["friction_force"], found["friction_force"], rtol=1e-12)

    def test_punches_uncoupled(self):
        """Without coupling a punch has the contact without friction, and what is left out is what a light coupling adds."""
        rest = solid(0.1) + "&friction shear_strength = {}, pressure_factor = {}{} /\n&operating load = 1e6, velocity = 0.1 /\n"
        for body in ("kind = 'line_punch', face_half_width = 0.01", "kind = 'wedge', slope = 0.05",
                     "kind = 'line_polynomial', coefficient_4 = 100.0", "kind = 'wedge', slope = 0.05, face_half_width = 0.5"):
            body = f"&surface {body} /\n"
            plain, _ = self.run_scene(body + solid(0.1) + "&operating load = 1e6 /\n")
            found, model = self.run_scene(body + rest.format(1e6, 0.3, ""))
            self.assertEqual(model, "rigid_punch")
            for key in plain.keys() & found.keys():
                np.testing.assert_array_equal(found[key], plain[key], err_msg=key)
            np.testing.assert_allclose(found["friction_force"], 2e6*found["contact_half_width"] + 0.3e6, rtol=1e-13)
            self.assertEqual(found["interfacial_share"], 1)
            if "polynomial" in body or "face_half_width = 0.5" in body:
                self.assertLess(found["coupling_left_out"], 0)
                continue
            # beyond all coefficients of friction the integrals have an end
            far = body + rest.format(0.0, 100.0, ", coupling = .true.")
            if "wedge" in body:
                self.write("&job output = 'run.h5' /\n" + far)
                self.run_program("run", "--quiet", "--force", "run.nml")
                with h5py.File(self.folder/"run.h5") as file:
                    self.assertEqual(file["status"][()], 2)
            light = [self.run_scene(body + rest.format(0.0, 0.01, word))[0] for word in ("", ", coupling = .true.")]
            change = (light[1]["friction_force"] - light[0]["friction_force"])/light[0]["friction_force"]
            np.testing.assert_allclose(light[0]["coupling_left_out"], change, rtol=1e-2, atol=1e-15)

    def test_viscoelastic_waves(self):
        """Every row of viscoelastic waves, which cells answer: friction, and the heat of the bulk and of the interface."""
        for row in table("int_visco_coupled"):
            r, a, mu, beta, q = (float(row[name]) for name in ("r", "a", "mu", "beta", "mean_pressure"))
            nu = (1 - 2*beta)/(2*(1 - beta))
            scene = WAVE + solid(nu).replace(" /", f", young_moduli = {(r - 1)*MODULUS*(1 - nu**2):.17g}, relaxation_times = 1.0 /")
            found, model = self.run_scene(scene + FRICTION.format(mu) + f"&operating mean_pressure = {q*MODULUS*SLOPE:.17g}, "
                                          f"velocity = {a*PERIOD/(2*np.pi):.17g} /\n&numerics cells = 2048 /\n")
            self.assertEqual(model, "surface_sliding")
            accuracy = max(3*float(row["uncertainty"]), 2e-5)
            unit = MODULUS*SLOPE**2
            force, heat = found["hysteretic_friction_stress"]/unit, found["dissipation"]/unit
            self.assertAlmostEqual(float(force), float(row["slope_friction_direct"]), delta=accuracy)
            self.assertAlmostEqual(float(heat), float(row["bulk_heat_per_distance"]), delta=accuracy)
            self.assertAlmostEqual(float(mu*q + force - heat), float(row["interface_heat_per_distance"]), delta=accuracy)
            self.assertAlmostEqual(float(found["contact_fraction"]), float(row["area_fraction"]), delta=2e-3)

    def test_reversal(self):
        """The other way all is the same, but for the signs of what is along the motion; and in other units of length, too."""
        for name, scene in SCENES.items():
            with self.subTest(scene=name):
                forward, _ = self.run_scene(scene + FRICTION.format(0.8))
                backward, _ = self.run_scene(scene.replace("velocity = ", "velocity = -") + FRICTION.format(0.8))
                self.assertEqual(forward.keys(), backward.keys())
                for key, value in forward.items():
                    signed = "friction" in key or key in ("contact_shift", "velocity")
                    if "error" not in key and key not in ("energy_imbalance", "contact_violation", "lateral_friction_stress"):
                        np.testing.assert_allclose(backward[key], -value if signed else value, rtol=1e-12, err_msg=f"{name}: {key}")
                self.assertGreater(forward["friction_force" if name == "hertz" else "friction_stress"], 0)
                large = re.sub(r"(period|amplitude|radius|thickness|load|velocity) = ([\d.e-]+)",
                               lambda found: f"{found[1]} = {float(found[2])*1e3!r}", scene)
                scaled, _ = self.run_scene(large + FRICTION.format(0.8))
                np.testing.assert_allclose(scaled["friction_coefficient"], forward["friction_coefficient"], rtol=1e-10)

    def test_energy(self):
        """T_s of an elastic wave follows from its own pressure, and the interface takes all of the friction."""
        found, _ = self.run_scene(SCENES["wave_1d"] + FRICTION.format(1.0) + f"&output profiles = .true., x_min = {-PERIOD/2}, "
                                  f"x_max = {PERIOD/2}, n_x = 4001 /\n")
        pressure, shear = found["pressure"].ravel()[:-1], found["shear_stress"].ravel()[:-1]
        x = np.linspace(-PERIOD/2, PERIOD/2, 4001)[:-1]
        m, modulus = 0.6/1.6, 1e9/(1 - 0.2**2)
        by_energy = -2*m/modulus*(np.mean(pressure**2) - np.mean(pressure)**2)
        on_slopes = np.mean(pressure*SLOPE*np.sin(2*np.pi*x/PERIOD))
        np.testing.assert_allclose(found["hysteretic_friction_stress"], by_energy, rtol=1e-5)
        np.testing.assert_allclose(found["hysteretic_friction_stress"], on_slopes, rtol=1e-4)
        np.testing.assert_allclose(shear, pressure)
        self.assertLess(abs(found["energy_imbalance"]), 1e-12)
        self.assertGreater(found["interfacial_share"], 1)

    def test_off(self):
        """With coupling = .false. the numbers are those without the name, and what is left out is what the coupling adds."""
        for name in ("wave_1d", "hertz", "surface_sliding", "relaxing", "layer"):
            with self.subTest(scene=name):
                scene = SCENES[name]
                friction = FRICTION.format(0.05)
                if name == "wave_1d":
                    scene = scene.replace(", velocity = 0.01", "")
                off, model = self.run_scene(scene + friction.replace(".true.", ".false."))
                on, _ = self.run_scene(SCENES[name] + friction)
                bare = scene.replace("&numerics cells = 512 /\n", "")
                if name == "surface_sliding":
                    bare = bare.replace(", velocity = 0.01", "")
                plain, other = self.run_scene(bare + friction.replace(", coupling = .true.", ""))
                if model == other and "cells" not in SCENES[name]:
                    for key in off.keys() & plain.keys():
                        np.testing.assert_array_equal(off[key], plain[key], err_msg=key)
                key = "friction_force" if name == "hertz" else "friction_stress"
                change = (on[key] - off[key])/off[key]
                self.assertNotIn("coupling_left_out", on)
                self.assertIn("coupling_left_out", off)
                self.assertNotIn("largest_coupling", off)
                # of a viscoelastic solid the change of the pressure is not in the number
                np.testing.assert_allclose(plain["coupling_left_out"], change, rtol=0.5 if name == "relaxing" else 0.02)

    def test_off_over_rubber(self):
        """With coupling = .false. the solver is that without the name, also over a viscoelastic solid, and so are all bits."""
        wave = SCENES["relaxing"].replace("&numerics cells = 512 /\n", "")
        cylinder = SCENES["hertz"].replace("0.2 /", "0.2, young_moduli = 9e9, relaxation_times = 1e-3 /")
        for scene, solver in ((wave, "wave_1d"), (cylinder, "hertz")):
            plain, model = self.run_scene(scene + FRICTION.format(0.3).replace(", coupling = .true.", ""))
            for word in (".false.", "F"):
                off, other = self.run_scene(scene + FRICTION.format(0.3).replace(".true.", word))
                self.assertEqual((model, other), (solver, solver))
                self.assertEqual(plain.keys() | {"coupling"}, off.keys() | {"coupling"})
                for key in plain:
                    np.testing.assert_array_equal(off[key], plain[key], err_msg=key)
                self.assertIn("coupling_left_out", off)

    def test_ellipsoid(self):
        """What an ellipsoid leaves out along either axis, against a transform of its pressure and shear stress."""
        scene = ("&surface kind = 'ellipsoid', radius_1x = 1e-2, radius_1y = 4e-2 /\n&solid young_modulus = 1e9, poisson_ratio = 0.3 /\n"
                 "&friction shear_strength = 1e6, pressure_factor = 0.2 /\n&operating load = 1.0, velocity = 0.1, direction = {} /\n")
        n, modulus, beta = 2048, 1e9/(1 - 0.3**2), 0.4/1.4
        for direction in (0.0, np.pi/2):
            found, model = self.run_scene(scene.format(repr(float(direction))))
            self.assertEqual(model, "hertz")
            a, b = float(found["major_half_width"]), float(found["minor_half_width"])
            # a square of 12 contacts; images fall off with the cube of the distance
            x = 12*a*(np.arange(n)/n - 0.5)
            pressure = found["peak_pressure"]*np.sqrt(np.maximum(0, 1 - (x/a)**2 - (x[:, None]/b)**2))
            shear = np.where(pressure > 0, 1e6 + 0.2*pressure, 0)
            k = 2*np.pi*np.fft.fftfreq(n, 12*a/n)
            square = k**2 + k[:, None]**2
            square[0, 0] = 1
            along = (k**2 if direction == 0 else k[:, None]**2)/square
            slope = np.fft.ifft2(2*beta/modulus*along*np.fft.fft2(shear)).real
            change = -np.sum(pressure*slope)*(12*a/n)**2/found["friction_force"]
            # 80 cells on the half-width, at whose end the shear stress jumps
            np.testing.assert_allclose(found["coupling_left_out"], change, rtol=2e-2)
            for absent in ("contact_shift", "energy_imbalance", "dissipation", "largest_shear_stress"):
                self.assertNotIn(absent, found)

    def write_heights(self, scale=1.0):
        """Rough heights that no reflection leaves as they are, as `heights.h5:/z` [m], 64 x 32 cells of 4 um."""
        n_x, n_y = 64, 32
        x, y = 2*np.pi*np.arange(n_x)/n_x, 2*np.pi*np.arange(n_y)[:, None]/n_y
        z = sum(a*np.cos(i*x + j*y + 1.3*i*j + 0.4*i) for i, j, a in ((1, 0, 1.0), (1, 1, 0.6), (2, -1, 0.4), (3, 2, 0.2), (5, -3, 0.1)))
        with h5py.File(self.folder/"heights.h5", "w") as file:
            file["z"] = scale*1e-6*z

    def by_transform(self, found, nu, period, modulus):
        """What is left out, from the maps of pressure and shear stress: mean of -p du/dx of the displacement u of q, over T."""
        pressure, shear = found["pressure"].squeeze(), found["shear_stress"].squeeze()
        if pressure.shape[-1] == pressure.shape[0] and period[0] == period[1] and pressure.shape[0] == 32:
            pressure, shear = (np.block([[map[::-1, ::-1], map[::-1]], [map[:, ::-1], map]]) for map in (pressure, shear))
        k_x, k_y = (2*np.pi*np.fft.fftfreq(n, length/n) for n, length in zip(pressure.shape[::-1], period))
        k = np.hypot(k_x, k_y[:, None])
        k[0, 0] = 1
        beta = (1 - 2*nu)/(2*(1 - nu))
        # u = -(2/(E* k)) i beta cos(phi) q and du/dx = i k_x u
        slope = np.fft.ifft2(2*beta/modulus*k_x**2/k**2*np.fft.fft2(shear)).real
        return -np.mean(pressure*slope)/found["friction_stress"]

    def test_elastic_surfaces(self):
        """What elastic surfaces leave out, also with adhesion and by a law, against a transform of their maps; in other units, too."""
        self.write_heights()
        nu, output = 0.3, "&output profiles = .true. /\n"
        solid = f"&solid young_modulus = 1e9, poisson_ratio = {nu} /\n"
        wave = f"&surface kind = 'wave_2d', period = {PERIOD}, amplitude = {AMPLITUDE} /\n&numerics cells = 64 /\n"
        rough = "&surface kind = 'heights', heights = 'heights.h5:/z', length_x = 2.56e-4, length_y = 1.28e-4 /\n"
        load = "&operating mean_pressure = 8e6 /\n"
        adhesion = "&adhesion work_of_adhesion = 2.0, adhesion_stress = 2e6 /\n"
        constant = "&friction shear_strength = 2e6 /\n"
        both = "&friction shear_strength = 2e6, pressure_factor = 0.4 /\n"
        law = ("&friction law = 'log_gaussian', peak_shear_strength = 3e6, peak_velocity = 1.0, log_width_factor = 0.1, "
               "pressure_factor = 0.2 /\n")
        for surface, period in ((wave, (PERIOD, PERIOD)), (rough, (2.56e-4, 1.28e-4))):
            for rest in (constant, both, both + adhesion, law):
                with self.subTest(surface=surface, rest=rest):
                    operating = load.replace(" /", ", velocity = -0.1 /") if rest == law else load
                    found, model = self.run_scene(surface + solid + rest + operating + output)
                    self.assertIn(model, ("wave_2d_elastic", "surface_elastic"))
                    modulus = 1e9/(1 - nu**2)
                    found["friction_stress"] = abs(found["friction_stress"])
                    found["shear_stress"] = abs(found["shear_stress"])
                    np.testing.assert_allclose(found["coupling_left_out"], self.by_transform(found, nu, period, modulus), rtol=2e-2)
                    self.assertLess(found["coupling_left_out"], -1e-3)
        plain, _ = self.run_scene(rough + solid + both + load)
        self.write_heights(1e3)
        large, _ = self.run_scene(rough.replace("2.56e-4", "2.56e-1").replace("1.28e-4", "1.28e-1") + solid + both + load)
        np.testing.assert_allclose(large["coupling_left_out"], plain["coupling_left_out"], rtol=1e-9)

    def test_adhesive_wave(self):
        """An adhesive wave in closed form leaves out what the same wave on cells does; two elastic bodies tell nothing."""
        adhesion = "&adhesion work_of_adhesion = 0.2, adhesion_stress = 4e6 /\n&friction shear_strength = 4e6, pressure_factor = 0.3 /\n"
        load = "&operating mean_pressure = 5e6 /\n"
        exact, model = self.run_scene(WAVE + "&solid young_modulus = 1e9, poisson_ratio = 0.2 /\n" + load + adhesion)
        self.assertEqual(model, "wave_1d")
        x = 2*np.pi*(np.arange(4096) + 0.5)/4096
        with h5py.File(self.folder/"wave.h5", "w") as file:
            file["z"] = AMPLITUDE*np.cos(x)
        line = f"&surface kind = 'profile', heights = 'wave.h5:/z', length_x = {PERIOD} /\n"
        cells, model = self.run_scene(line + "&solid young_modulus = 1e9, poisson_ratio = 0.2 /\n" + load + adhesion)
        self.assertEqual(model, "surface_elastic")
        np.testing.assert_allclose(cells["coupling_left_out"], exact["coupling_left_out"], rtol=2e-3)
        bodies = "&solid young_modulus = 1e9, poisson_ratio = 0.2, second_young_modulus = 1e9, second_poisson_ratio = 0.3 /\n"
        for scene in (WAVE, line):
            found, _ = self.run_scene(scene + bodies + load + adhesion)
            self.assertTrue(np.isnan(found["coupling_left_out"]))

    def test_check_of_cells(self):
        """`check` names the trial points of cells whose coupling counts; none where it is below the error, or 0."""
        wave = SCENES["surface_sliding"].replace(", velocity = 0.01", "")
        wave = wave.replace("cells = 64", "cells = 256").replace("mean_pressure = 1e7", "mean_pressure = 5e7")
        friction = "&friction shear_strength = 1e7 /\n"
        for text, is_told, counts in ((wave, True, True), (wave.replace("0.2", "0.5"), False, False),
                                      (wave.replace("1e-05", "1e-08").replace("5e7", "5e4"), True, False)):
            with self.subTest(text=text):
                self.write("&job output = 'run.h5' /\n" + text + friction)
                page, _ = self.run_program("check", "run.nml")
                self.assertEqual("shear stress moves the contact where" in page, is_told, page)
                self.assertEqual(bool(re.search(r"coupling left out at (\d+) of \1 trial points", page)), counts, page)

    def test_check(self):
        """`check` says what is left out, and by how much; nothing where it is taken in or 0."""
        for name in ("wave_1d", "hertz"):
            scene = SCENES[name] if name == "hertz" else SCENES[name].replace(", velocity = 0.01", "")
            friction = FRICTION.format(0.5).replace(", coupling = .true.", "")
            self.write("&job output = 'run.h5' /\n" + scene + friction)
            page, _ = self.run_program("check", "run.nml")
            found, _ = self.run_scene(scene + friction)
            said = re.search(r"it changes the friction by +(\S+) of it to first order, beside an error of", page)
            self.assertIsNotNone(said, page)
            np.testing.assert_allclose(float(said[1]), found["coupling_left_out"], rtol=0.06)
            for text in (SCENES[name] + FRICTION.format(0.5), scene.replace("0.2", "0.5") + friction):
                self.write("&job output = 'run.h5' /\n" + text)
                page, _ = self.run_program("check", "run.nml")
                self.assertNotIn("changes the friction", page)
        self.write("&job output = 'run.h5' /\n" + SCENES["relaxing"] + FRICTION.format(0.5))
        page, _ = self.run_program("check", "run.nml")
        self.assertIn("surface_sliding", page)
        self.assertNotIn("the only one", page)
        thin = SCENES["layer"].replace("poisson_ratio = 0.4", "poisson_ratio = 0.49, young_moduli = 9e9, relaxation_times = 2e-2")
        for text, is_doubted in ((thin + FRICTION.format(1.5), True), (thin + FRICTION.format(0.05), False)):
            self.write("&job output = 'run.h5' /\n" + text)
            page, _ = self.run_program("check", "run.nml")
            self.assertEqual("nothing proves that the contact is the only one" in page, is_doubted, page)
            found, _ = self.run_scene(text)
            self.assertEqual(found["smallest_stiffness_ratio"] < 0, is_doubted)

    def test_no_state(self):
        """A constant shear stress that moves more than the contact has no state; a cylinder on rubber has no such solver to name."""
        friction = "&friction shear_strength = 2e3, coupling = .true. /\n"
        for scene in (SCENES["hertz"].replace("1e9", "1e6").replace("1e3", "1e-6"),
                      SCENES["wave_1d"].replace("1e9", "1e6").replace("1e7", "1e-9")):
            self.write("&job output = 'run.h5' /\n" + scene + friction)
            self.run_program("run", "--quiet", "--force", "run.nml")
            with h5py.File(self.folder/"run.h5") as file:
                self.assertEqual(file["status"][()], 2)
                self.assertTrue(np.isnan(file["error_estimate"][()]))
        rubber = SCENES["hertz"].replace("0.2 /", "0.2, young_moduli = 9e9, relaxation_times = 1e-3 /")
        self.write("&job output = 'run.h5' /\n" + rubber + FRICTION.format(0.5).replace(", coupling = .true.", ""))
        page, _ = self.run_program("check", "run.nml")
        self.assertIn("changes the friction", page)
        self.assertNotIn("coupling = .true.", page)

    def test_refused(self):
        """One line, status 2."""
        friction = FRICTION.format(0.5)
        wave = SCENES["wave_1d"]
        columns = WAVE + ("&solid extent = 'foundation', stiffness = 1e13, relaxation_time = 1e-3, retardation_ratio = 5.0 /\n"
                          "&operating mean_pressure = 1e6, velocity = 0.01 /\n")
        for text, message in (
                (wave.replace("young_modulus = 1e9, poisson_ratio = 0.2", "contact_modulus = 1e9") + friction, "poisson_ratio"),
                (wave.replace(", velocity = 0.01", "") + friction, "velocity"),
                (wave + "&friction coupling = .true. /\n", "nothing solves"),
                (wave + "&friction coulomb_coefficient = 0.3, coupling = .true. /\n", "nothing solves"),
                (columns + friction, "coupling"),
                (wave + friction.replace("strength = 0.0", "strength = 1e6") + "&adhesion work_of_adhesion = 0.05, adhesion_stress = 1e6 /\n", "beside adhesion"),
                (SCENES["layer"].replace("bonded", "frictionless") + friction, "coupling"),
                (PUNCH.format("kind = 'wedge', slope = 0.1") + friction.replace("= 0.0", "= 1e5"), "a punch takes shear_strength = 0"),
                (PUNCH.format("kind = 'wedge', slope = 0.1, face_half_width = 1.0") + friction, "has no closed form for this punch"),
                (PUNCH.format("kind = 'line_polynomial', coefficient_4 = 1.0") + friction, "has no closed form for this punch"),
                (PUNCH.format("kind = 'wedge', slope = 0.1").replace("poisson_ratio = 0.3, young", "contact") + friction, "needs poisson_ratio"),
                (SCENES["surface_sliding"] + friction.replace("shear_strength = 0.0", "shear_strength = 1e5"), "shear_strength = 0"),
                (SCENES["hertz"].replace("cylinder", "paraboloid").replace("velocity = 0.01", "state = 'sliding'")
                 + "&friction shear_strength = 1e5, coupling = .true. /\n", "coupling")):
            with self.subTest(text=text):
                self.write("&job output = 'run.h5' /\n" + text)
                _, errors = self.run_program("run", "--quiet", "--force", "run.nml", status=2)
                self.assertIn(message, errors)


if __name__ == "__main__":
    main()
