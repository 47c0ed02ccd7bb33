# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of results files: one HTML file each, with interactive figures."""
