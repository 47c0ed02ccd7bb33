# SPDX-License-Identifier: GPL-3.0-or-later
# What the Python package contains (pyproject.toml): the shared libraries and the command, side by side.

set_target_properties(adfric_run adfric_physics PROPERTIES INSTALL_RPATH "$ORIGIN")
set_target_properties(adfric PROPERTIES INSTALL_RPATH "$ORIGIN/../lib")
# a wheel has no links: each library is one file
set_property(TARGET adfric_run adfric_physics PROPERTY VERSION)
set_property(TARGET adfric_run adfric_physics PROPERTY SOVERSION)
install(TARGETS adfric_run adfric_physics LIBRARY DESTINATION adfric/lib COMPONENT python)
install(TARGETS adfric RUNTIME DESTINATION adfric/bin COMPONENT python)
