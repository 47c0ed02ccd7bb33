# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of what scripts/importing does."""

import contextlib
import io
import os

from runs import Runs


class ImportCase(Runs):
    """Imports in a folder of their own; `program` is the name of the command, and `import_main` what it does."""

    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def call(self, *arguments, status=0):
        """What an import shows on standard output and on standard error."""
        output, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            found = type(self).import_main([str(argument) for argument in arguments])
        self.assertEqual(found, status, errors.getvalue())
        return output.getvalue(), errors.getvalue()

    def refuse(self, words, *arguments, status=2):
        """An import that ends in one line with these words, and leaves no file."""
        before = self.names()
        output, errors = self.call(*arguments, status=status)
        self.assertEqual(output, "")
        self.assertEqual(errors.count("\n"), 1, errors)
        self.assertTrue(errors.startswith(f"{self.program}: "), errors)
        self.assertIn(words, errors)
        self.assertEqual(self.names(), before)
