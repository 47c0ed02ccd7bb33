# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits of force curves in time: the reference sets, curves of several speeds, members of lists, what one curve cannot say, and what is
refused."""

import sys
from pathlib import Path

import h5py
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from runs import Runs, main  # noqa: E402

REFERENCE = Path(__file__).resolve().parents[1] / "reference"
BALL = "&job output = 'run.h5' /\n&surface kind = 'paraboloid', radius = 5e-6 /\n"
ARM = "&solid moduli = 1.5e3, relaxation_times = 0.05 /\n"
DATA = "&data file = '{file}', abscissa = 'time', ordinate = 'load', variables = 'approaches', variable_columns = 'base' /\n"
FREE = "&free variable = 'modulus' /\n&free variable = 'solid%moduli(1)' /\n&free variable = 'solid%relaxation_times(1)' /\n" \
    "&free variable = 'contact_point' /\n&free variable = 'load_offset' /\n"
# one search
ONCE = "&fit starts = 1 /\n"
# estimates in standard errors, standard errors as a part of themselves, S
ESTIMATE, ERROR, CHI2 = 1e-3, 1e-2, 1e-4
# estimate and standard error, of logarithms where they are positive, and S of the digits of the tables (independent fits)
SETS = {
    "sls": (497.198102, {"modulus": (-0.009909020222 + np.log(1e3), 0.008319012430), "moduli_1": (0.696563933866 + np.log(1e3), 0.002393211656),
                         "relaxation_times_1": (-2.292398889527, 0.009073165952), "contact_point": (0.299406795332e-6, 0.000718886264e-6),
                         "load_offset": (0.049834930381e-9, 0.002299873398e-9)}),
    "drift": (476.333653, {"modulus": (-0.708697256574 + np.log(1e3), 0.013621478069), "moduli_1": (0.408087578294 + np.log(1e3), 0.001632045484),
                           "relaxation_times_1": (-3.000307582386, 0.006002796671), "contact_point": (0.202923580910e-6, 0.001854228122e-6),
                           "drift_rate": (0.360250251083e-6, 0.036097867052e-6), "load_offset": (-0.000727541127e-9, 0.001543946317e-9)}),
}


class TimeFits(Runs):
    """Fits over time."""

    def read(self, name):
        """The numbers of a file, those of one point as numbers."""
        with h5py.File(self.folder / name) as file:
            return {name: np.squeeze(item[()]) for name, item in file.items() if isinstance(item, h5py.Dataset) and item.dtype.kind == "f"}

    def answer(self, text):
        """Results and printed lines of a fit."""
        self.write(text)
        printed, _ = self.run_program("fit", "--force", "run.nml")
        return self.read("run.h5"), printed

    def refuse(self, text, words):
        """An input is refused in one line with these words."""
        self.refuse_in_line("fit", text, words)

    def test_cell(self):
        """The cell of the guide: its power law is found, one arm is refuted, two are not."""
        text = (REFERENCE.parents[1] / "inputs/fit_cell.nml").read_text()
        text = text.replace("'fit_cell.csv'", f"'{REFERENCE.parents[1] / 'inputs/fit_cell.csv'}'").replace("fit_cell.h5", "run.h5")
        found, _ = self.answer(text)
        self.assertLess(abs(found["power_law_modulus"] / 800 - 1), 2 * found["power_law_modulus_error"] / 800)
        self.assertLess(abs(found["power_law_exponent"] - 0.15), 2 * found["power_law_exponent_error"])
        self.assertLess(abs(found["contact_point"] - 0.4e-6), 2 * found["contact_point_error"])
        sums = [found["chi2"]]
        bare = "\n\n".join(part for part in text.split("\n\n") if "power_law" not in part)
        arms = "&solid moduli = {}, relaxation_times = {} /\n"
        free = "&free variable = 'modulus' /\n" + "".join(f"&free variable = 'solid%{name}({{0}})' /\n" for name in ("moduli", "relaxation_times"))
        for moduli, times in (("500", "0.1"), ("500, 300", "0.03, 0.5")):
            count = len(moduli.split(","))
            own = free.format(1) + "".join(free.split("\n", 1)[1].format(k) for k in range(2, count + 1))
            found, _ = self.answer(bare + arms.format(moduli, times) + own)
            sums.append(found["chi2"])
        for chi2, wanted in zip(sums, (507, 3790, 555)):
            self.assertLess(abs(chi2 / wanted - 1), 2e-3)

    def test_reference(self):
        """The sets of an independent program, with and without drift."""
        for name, (chi2, answers) in SETS.items():
            drift = "&free variable = 'drift_rate' /\n" if name == "drift" else ""
            found, _ = self.answer(BALL + ARM + DATA.format(file=REFERENCE / f"vit_fit_{name}.csv") + FREE + drift)
            self.assertLess(abs(found["chi2"] - chi2), CHI2)
            for word, (wanted, error) in answers.items():
                is_log = word in ("modulus", "moduli_1", "relaxation_times_1")
                value = np.log(found[word]) if is_log else found[word]
                spread = found[word + "_error"]/(found[word] if is_log else 1)
                self.assertLess(abs(value - wanted), ESTIMATE*error, (name, word))
                self.assertLess(abs(spread - error), ERROR*error, (name, word))

    def test_power_law(self):
        """A power law from an independent set: points and fit by a quadrature of its own, with Gauss and Newton's method."""
        radius, speed, top, noise = 5e-6, 1e-5, 0.2, 1e-10
        times = 0.0008*np.arange(1, 501)
        base = speed*np.minimum(times, 2*top - times)
        k = 0.045*np.arange(-90, 91)
        turned = np.pi/2*np.sinh(k)
        x, rest = 1/(1 + np.exp(-2*turned)), 1/(1 + np.exp(2*turned))
        weights = 0.045*np.pi*np.cosh(k)*x*rest

        def load_of(numbers):
            modulus, exponent, contact, offset = np.exp(numbers[0]), *numbers[1:]
            touch = contact/speed
            earlier = np.where(times <= top, times, times - 2**(1/(1 - exponent))*(times - top)) - touch
            load = np.full(times.shape, offset)
            for i in np.flatnonzero((earlier > 0) & (times > touch)):
                lag = times[i] - touch - earlier[i] + earlier[i]*rest
                load[i] += np.sum(weights*modulus*lag**-exponent*2*np.sqrt(radius*speed*earlier[i]*x))*speed*earlier[i]
            return load

        found = np.array([np.log(800), 0.25, 4e-7, 0])
        size = np.array([1, 1, 1e-6, 1e-9])
        load = np.round(load_of(found) + noise*np.random.default_rng(35).standard_normal(times.shape), 18)
        for _ in range(8):
            residual = (load_of(found) - load)/noise
            slopes = np.array([(load_of(found + 1e-5*step) - load_of(found - 1e-5*step))/(2e-5*noise) for step in np.diag(size)]).T
            covariance = np.linalg.inv(slopes.T @ slopes)
            found = found - size*(covariance @ (slopes.T @ residual))
        error = size*np.sqrt(np.diag(covariance))
        (self.folder / "power.csv").write_text("time [s],base [um],load [nN],sigma [nN]\n" + "".join(
            f"{t:.4f},{z*1e6:.3f},{p*1e9:.9f},{noise*1e9}\n" for t, z, p in zip(times, base, load)))
        text = BALL + DATA.format(file="power.csv") + FREE.replace("solid%relaxation_times(1)", "power_law_exponent")
        text = text.replace("&free variable = 'modulus' /\n", "").replace("solid%moduli(1)", "power_law_modulus")
        answer, printed = self.answer(text)
        self.assertIn("power_law_exponent", printed)
        for name, wanted, spread in zip(("power_law_modulus", "power_law_exponent", "contact_point", "load_offset"), found, error):
            value, own = answer[name], answer[name + "_error"]
            if name == "power_law_modulus":
                value, own = np.log(value), own/value
            self.assertLess(abs(value - wanted), ESTIMATE*spread, name)
            self.assertLess(abs(own - spread), ERROR*spread, name)
        self.assertLess(abs(answer["chi2"] - np.sum(((load_of(found) - load)/noise)**2)), CHI2)

    def make(self, name, speed, arms, contact=2e-7, noise=1e-11):
        """A curve of the program itself: press to 1 um at a speed and retract, with noise."""
        top = 1e-6/speed
        times = np.linspace(0, 2*top, 201)
        base = speed*np.minimum(times, 2*top - times)
        lists = ", ".join(f"{t:.17g}" for t in times), ", ".join(f"{z:.17g}" for z in base)
        self.write(BALL + arms + f"&history times = {lists[0]}\n approaches = {lists[1]}\n contact_point = {contact} /\n")
        self.run_program("run", "--quiet", "--force", "run.nml")
        load = self.read("run.h5")["load"]
        load = load + noise*np.random.default_rng(1).standard_normal(load.shape)
        (self.folder / name).write_text("time,base,load,sigma\n" + "".join(
            f"{t:.17g},{z:.17g},{p:.17g},{noise}\n" for t, z, p in zip(times, base, load)))

    def test_speeds(self):
        """Two arms from curves of three speeds, each with its own history and contact point."""
        arms = "&solid modulus = 500, moduli = 1e3, 800, relaxation_times = 0.02, 1 /\n"
        contacts = (1e-7, 2e-7, 1.5e-7)
        text = BALL + ONCE + "&solid moduli = 500, 500, relaxation_times = 0.05, 0.5 /\n"
        for k, speed in enumerate((5e-5, 5e-6, 5e-7)):
            self.make(f"curve_{k}.csv", speed, arms, contacts[k])
            text += DATA.format(file=f"curve_{k}.csv") + f"&free variable = 'data[{k + 1}]%contact_point' /\n"
        for word in ("modulus", "moduli(1)", "moduli(2)", "relaxation_times(1)", "relaxation_times(2)"):
            text += f"&free variable = '{word}' /\n"
        found, printed = self.answer(text)
        wanted = {"modulus": 500, "moduli_1": 1e3, "moduli_2": 800, "relaxation_times_1": 0.02, "relaxation_times_2": 1}
        wanted.update({f"contact_point_{k + 1}": contacts[k] for k in range(3)})
        for word, value in wanted.items():
            self.assertLess(abs(found[word] - value), 4*found[word + "_error"], (word, found[word], value))
        self.assertNotIn("arm", printed)

    def test_one_curve(self):
        """A slow arm and a fast one are not known from one curve, and the table says what is."""
        for time, words in ((10, "sum of"), (1e-3, "viscosity")):
            self.make("curve.csv", 5e-6, f"&solid modulus = 500, moduli = 1e3, relaxation_times = {time} /\n")
            text = BALL + f"&solid moduli = 1e3, relaxation_times = {time} /\n" + DATA.format(file="curve.csv") + FREE + ONCE
            _, printed = self.answer(text)
            self.assertIn(words, printed)
            self.assertIn("S at the start", self.run_program("check", "run.nml")[0])

    def test_what_is_known(self):
        """Moduli of a slow arm are known by their sum, whether its time is free or not, an elastic solid has no arm, and two arms of one
        curve have no answer or none that is silent."""
        free = FREE.replace("&free variable = 'solid%relaxation_times(1)' /\n", "")
        for time, text, words in ((1, FREE, "are known by their sum"), (40, free, "are known by their sum"), (1e-3, FREE, "a viscosity of"),
                                  (1e12, FREE, "is 0 within its error")):
            self.make("curve.csv", 5e-6, f"&solid modulus = 500, moduli = 1e3, relaxation_times = {time} /\n")
            start = f"&solid moduli = 1e3, relaxation_times = {40 if text == free else 0.1} /\n"
            self.assertIn(words, self.answer(BALL + start + DATA.format(file="curve.csv") + text)[1], time)
        self.make("curve.csv", 5e-6, "&solid modulus = 500, moduli = 1e3, 800, relaxation_times = 0.02, 1 /\n")
        two = "&free variable = 'solid%moduli(2)' /\n&free variable = 'solid%relaxation_times(2)' /\n"
        self.write(BALL + "&solid moduli = 500, 500, relaxation_times = 0.05, 0.5 /\n" + DATA.format(file="curve.csv") + FREE + two)
        printed, _ = self.run_program("fit", "--force", "run.nml")
        self.assertIn("more arms", printed)

    def test_young(self):
        """Young's moduli are contact moduli times 1 - nu^2, with their errors."""
        self.make("curve.csv", 5e-6, "&solid modulus = 500, moduli = 1e3, relaxation_times = 0.05 /\n")
        plain, _ = self.answer(BALL + ARM + DATA.format(file="curve.csv") + FREE + ONCE)
        young = "&solid young_moduli = 1.5e3, relaxation_times = 0.05, poisson_ratio = 0.4 /\n"
        found, _ = self.answer(BALL + young + DATA.format(file="curve.csv") + FREE.replace("'modulus'", "'young_modulus'").replace(
            "moduli(1)", "young_moduli(1)") + ONCE)
        for word, other, factor in (("modulus", "young_modulus", 0.84), ("moduli_1", "young_moduli_1", 0.84),
                                    ("relaxation_times_1", "relaxation_times_1", 1), ("contact_point", "contact_point", 1)):
            self.assertLess(abs(found[other] - factor*plain[word]), ESTIMATE*factor*plain[word + "_error"], word)
            self.assertLess(abs(found[other + "_error"] - factor*plain[word + "_error"]), ESTIMATE*factor*plain[word + "_error"], word)
        self.assertLess(abs(found["chi2"] - plain["chi2"]), CHI2)

    def test_map_order(self):
        """A map has the same bits whatever the threads and the order of its curves, each with its own history."""
        rng = np.random.default_rng(64)
        curves = []
        for k in range(8):
            self.make("curve.csv", 3e-6*(1 + k), f"&solid modulus = {400 + 50*k}, moduli = 1e3, relaxation_times = 0.1 /\n", (1 + 0.2*k)*1e-7)
            curves.append(np.genfromtxt(self.folder / "curve.csv", delimiter=",", skip_header=1).T[:3])
        order = rng.permutation(8)
        answers = []
        for which, threads in ((np.arange(8), 1), (np.arange(8), 2), (order, 2)):
            with h5py.File(self.folder / "map.h5", "w") as file:
                for column, name in enumerate(("time", "base", "load")):
                    file[name] = np.reshape([curves[k][column] for k in which], (2, 4, -1))
            self.write(BALL + ARM + "&data file = 'map.h5:/load', abscissa = 'time', abscissa_column = 'time', ordinate = 'load', "
                       "sigma = 1e-11, variables = 'approaches', variable_columns = 'base' /\n" + FREE + ONCE)
            self.run_program("fit", "--quiet", "--force", "run.nml", threads=threads)
            with h5py.File(self.folder / "run.h5") as file:
                found = np.array([file[name][()].ravel() for name in ("modulus", "modulus_error", "moduli_1", "contact_point", "chi2")])
            back = np.empty_like(found)
            back[:, which] = found
            answers.append(back)
        np.testing.assert_array_equal(answers[0], answers[1])
        np.testing.assert_array_equal(answers[0], answers[2])

    def test_refused(self):
        """Members that are not there, histories that do not go together."""
        (self.folder / "curve.csv").write_text("time,base,load\n0,0,0\n1,1e-6,1e-9\n2,0,0\n")
        (self.folder / "falls.csv").write_text("time,base,load\n0,0,0\n1,1e-6,1e-9\n0.5,0,0\n")
        data = DATA.format(file="curve.csv")
        free = "&free variable = 'modulus' /\n"
        for member, words in (("moduli(2)", "moduli has 1 values, given 2, allowed: 1 to 1"), ("moduli(0)", "no member of a list"),
                              ("moduli(x)", "no member of a list"), ("modulus(1)", "is no list"), ("times(1)", "is not given"),
                              ("young_moduli(1)", "is not given")):
            self.refuse(BALL + ARM.replace("moduli", "modulus = 1, moduli") + data + f"&free variable = '{member}' /\n", words)
        self.refuse(BALL + ARM + DATA.format(file="falls.csv") + free, "the time falls from 1 s to 0.5 s")
        self.refuse(BALL + ARM + data + "&history times = 0, 1, loads = 0, 1e-9 /\n" + free, "has a history, and &history has times")
        self.refuse(BALL + ARM + data + "&data file = 'curve.csv', abscissa = 'time', ordinate = 'load', sigma = 1 /\n" + free, "needed: one of each")
        self.refuse(BALL + ARM + data.replace("'load'", "'largest_load'") + free, "allowed: load, approach, contact_radius")
        with h5py.File(self.folder / "map.h5", "w") as file:
            for name in ("load", "base", "load_2"):
                file[name] = np.ones((2, 3))
            file["time"] = np.arange(3.0)
            file["short"] = np.ones((2, 2))
        stack = DATA.format(file="map.h5:/load").replace("'load',", "'load', sigma = 1e-11,")
        self.refuse(BALL + ARM + stack.replace("'base'", "'short'") + free, "the shape is not that of the ordinate")
        self.refuse(BALL + ARM + stack.replace("'approaches'", "'approaches', 'contact_point'").replace("'base'", "'base', 'base'") + free, "beside a stack of curves")
        self.refuse(BALL + ARM + stack + stack.replace("/load", "/load_2") + free, "is one of several stacks of curves over time")

    def test_map(self):
        """A map: each curve has its own history, in SI units or others, and the answer that it has alone; one without a history has none."""
        moduli, contacts = np.array([[500, 800, 300], [600, 400, 700]]), np.array([[1, 2, 1.5], [2.5, 1.2, 3]])*1e-7
        loads, bases, times = [], [], []
        for k in range(6):
            self.make("curve.csv", 4e-6*(1 + k), f"&solid modulus = {moduli.flat[k]}, moduli = 1e3, relaxation_times = 0.1 /\n", contacts.flat[k])
            columns = np.genfromtxt(self.folder / "curve.csv", delimiter=",", skip_header=1).T
            times.append(columns[0])
            bases.append(columns[1])
            loads.append(columns[2])
        times[4] = times[4][::-1]
        with h5py.File(self.folder / "map.h5", "w") as file:
            for name, values in (("load", loads), ("time", times), ("base", np.array(bases)*1e6)):
                file[name] = np.reshape(values, (2, 3, -1))
            file["base"].attrs["units"] = "um"
        fit = "&data file = '{}', abscissa = 'time', abscissa_column = 'time', ordinate = 'load', sigma = 1e-11, variables = 'approaches', " \
            "variable_columns = 'base' /\n" + FREE + ONCE
        self.write(BALL + ARM + fit.format("map.h5:/load"))
        self.run_program("fit", "--quiet", "--force", "run.nml")
        with h5py.File(self.folder / "run.h5") as file:
            found = {name: file[name][()] for name in ("modulus", "modulus_error", "contact_point", "contact_point_error", "chi2", "status")}
        expected = np.zeros((2, 3))
        expected[1, 1] = 1
        np.testing.assert_array_equal(found["status"], expected)
        good = expected == 0
        self.assertLess(np.max(np.abs(found["modulus"] - moduli)[good]/found["modulus_error"][good]), 4)
        self.assertLess(np.max(np.abs(found["contact_point"] - contacts)[good]/found["contact_point_error"][good]), 4)
        alone, _ = self.answer(BALL + ARM + fit.format("curve.csv"))
        for name in ("modulus", "modulus_error", "contact_point", "chi2"):
            self.assertLess(abs(found[name][1, 2]/alone[name] - 1), 1e-6, name)

    def test_map_of_one_history(self):
        """Curves of the history of the scene, a list or a path, without lists of their own that vary."""
        self.make("curve.csv", 5e-6, "&solid modulus = 500, moduli = 1e3, relaxation_times = 0.05 /\n", 0)
        columns = np.genfromtxt(self.folder / "curve.csv", delimiter=",", skip_header=1).T
        with h5py.File(self.folder / "map.h5", "w") as file:
            file["load"] = np.array([columns[2], 2*columns[2]])
            file["time"] = columns[0]
        for history in ("times = 0, 0.2, 0.4, approaches = 0, 1e-6, 0", "path = 'triangle', largest_approach = 1e-6, approach_rate = 5e-6"):
            self.write(BALL + ARM.replace("1.5e3", "1e3") + f"&history {history} /\n&data file = 'map.h5:/load', abscissa = 'time', "
                       "ordinate = 'load', sigma = 1e-11 /\n&free variable = 'modulus' /\n")
            self.run_program("fit", "--quiet", "--force", "run.nml")
            with h5py.File(self.folder / "run.h5") as file:
                self.assertLess(abs(file["modulus"][0] - 500), 4*file["modulus_error"][0])
                self.assertGreater(file["modulus"][1], file["modulus"][0])


if __name__ == "__main__":
    main()
