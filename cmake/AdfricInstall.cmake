# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts into a prefix, and the packages by which CMake and pkg-config find it there, wherever the prefix is
# moved to. CMake finds the build tree, too.

include(CMakePackageConfigHelpers)
include(AdfricPkgConfig)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/adfric")
set_target_properties(adfric PROPERTIES INSTALL_RPATH_USE_LINK_PATH TRUE)
if(NOT "static" IN_LIST ADFRIC_KINDS)
  file(RELATIVE_PATH lib_from_bin "${CMAKE_INSTALL_FULL_BINDIR}" "${CMAKE_INSTALL_FULL_LIBDIR}")
  set_target_properties(adfric PROPERTIES INSTALL_RPATH "$ORIGIN/${lib_from_bin}")
endif()
install(TARGETS adfric RUNTIME)

# modules, and the targets of each kind
foreach(name physics run)
  install(DIRECTORY "${PROJECT_BINARY_DIR}/mod/adfric_${name}/" DESTINATION "${CMAKE_INSTALL_MODULEDIR}/${name}"
    FILES_MATCHING PATTERN "*.mod")
  foreach(kind ${ADFRIC_KINDS})
    install(EXPORT adfric_${name}_${kind} NAMESPACE adfric:: DESTINATION "${package_folder}")
    export(EXPORT adfric_${name}_${kind} NAMESPACE adfric:: FILE "${PROJECT_BINARY_DIR}/adfric_${name}_${kind}.cmake")
  endforeach()
endforeach()

# the header for C
install(FILES include/adfric.h DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")

# the package for CMake
configure_file("${PROJECT_SOURCE_DIR}/cmake/adfricConfig.cmake.in" "${PROJECT_BINARY_DIR}/adfricConfig.cmake" @ONLY)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/adfricConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
configure_file("${PROJECT_SOURCE_DIR}/cmake/FindFFTW3.cmake" "${PROJECT_BINARY_DIR}/FindFFTW3.cmake" COPYONLY)
install(FILES "${PROJECT_BINARY_DIR}/adfricConfig.cmake" "${PROJECT_BINARY_DIR}/adfricConfigVersion.cmake" cmake/FindFFTW3.cmake
  DESTINATION "${package_folder}")

# the packages for pkg-config
adfric_write_pkg_config(adfric_physics ${GSL_LIBRARIES} ${FFTW3_LIBRARY} ${LAPACK_LIBRARIES})
adfric_write_pkg_config(adfric ${HDF5_Fortran_HL_LIBRARIES} ${HDF5_HL_LIBRARIES} ${HDF5_Fortran_LIBRARIES} ${HDF5_LIBRARIES}
  ${MPI_Fortran_LIBRARIES})

# what people read
configure_file("${PROJECT_SOURCE_DIR}/docs/adfric.1.in" "${PROJECT_BINARY_DIR}/adfric.1" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/adfric.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES scripts/completion/adfric.bash DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME adfric)
install(FILES scripts/completion/_adfric DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
install(DIRECTORY inputs/ DESTINATION "${CMAKE_INSTALL_DATADIR}/adfric/inputs" FILES_MATCHING PATTERN "*.nml" PATTERN "*.csv")
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY docs DESTINATION "${CMAKE_INSTALL_DOCDIR}" FILES_MATCHING PATTERN "*.md")
if(IS_DIRECTORY "${PROJECT_SOURCE_DIR}/examples")
  install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DOCDIR}")
endif()

# Everything that is installed, and nothing else, for scripts/install.
add_custom_target(installable DEPENDS adfric)
foreach(target adfric_physics adfric_physics_shared adfric_run adfric_run_shared)
  if(TARGET ${target})
    add_dependencies(installable ${target})
  endif()
endforeach()

# Take away what was installed last.
if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(uninstall COMMAND "${CMAKE_COMMAND}" "-DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt"
    -P "${PROJECT_SOURCE_DIR}/cmake/uninstall.cmake" VERBATIM)
endif()
