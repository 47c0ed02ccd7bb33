# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures of results files."""
