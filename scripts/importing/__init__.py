# SPDX-License-Identifier: GPL-3.0-or-later
"""Measured surfaces and master curves, as the files of instruments have them, and as the models want them."""
