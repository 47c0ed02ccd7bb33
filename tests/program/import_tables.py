# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader of tables in Python, over the dialects of tests/reference/tables, which the program reads as well."""

# first, since it starts the file again with the Python that has SurfaceTopography
from imports import SOURCE, Imports

import csv

import numpy as np
from runs import main

from importing.problems import BadTable
from importing.quantities import read_unit
from importing.tables import read_table

FOLDER = SOURCE / "tests/reference/tables"
ROUND_OFF = 4 * np.finfo(float).eps


def column_of(path, name, wanted):
    """A column in SI units, as a program would ask for it."""
    table = read_table(path, needs_names=True)
    place = table.find(name)
    text = table.unit(place)
    unit, si = read_unit(text) if text else read_unit(wanted), read_unit(wanted)
    if unit is None or unit.powers != si.powers:
        raise BadTable("unit", f"{path}: the unit '{text}' is not known, or one of another quantity")
    return table, table.column(place) * 10.0 ** unit.exponent


class Dialects(Imports):
    def test_dialects(self):
        with (FOLDER / "index.csv").open(newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["file"] for row in rows}, {path.name for path in FOLDER.iterdir()} - {"index.csv", "README.md"})
        for row in rows:
            with self.subTest(file=row["file"], column=row["column"]):
                path = FOLDER / row["file"]
                if row["outcome"] == "refused":
                    with self.assertRaises(BadTable) as caught:
                        column_of(path, row["column"], row["unit"])
                    self.assertEqual(caught.exception.reason, row["expected"], str(caught.exception))
                    self.assertNotIn("\n", str(caught.exception))
                    continue
                table, values = column_of(path, row["column"], row["unit"])
                np.testing.assert_allclose(values, np.array(row["expected"].split(), float), rtol=ROUND_OFF)
                self.assertEqual([table.separator, table.decimal, str(table.names_line or ""), str(table.units_line or "")],
                                 [row[key] for key in ("separator", "decimal", "names", "units")])

    def test_time_is_in_proportion(self):
        """A wide table and a long one have as many cells as read."""
        for rows, columns in ((3, 20000), (20000, 3)):
            for text in ("1.5", "1,5"):
                lines = [";".join(f"c{i} [nN]" for i in range(columns))] + [";".join([text] * columns)] * rows
                self.write("\n".join(lines), "a.csv")
                table = read_table(self.folder / "a.csv", needs_names=True)
                self.assertEqual(table.values.shape, (rows, columns))
                self.assertTrue((table.column(table.find(f"c{columns - 1}")) == 1.5).all())


if __name__ == "__main__":
    main()
