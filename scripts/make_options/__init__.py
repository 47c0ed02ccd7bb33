# SPDX-License-Identifier: GPL-3.0-or-later
"""The options of the scripts that make data, which need no packages: help is there before anything is installed."""
