# SPDX-License-Identifier: GPL-3.0-or-later
# Gives add_pfunit_ctest(): from an installed pFUnit 4 or, without one, from the project's own runner, which
# understands a subset of the same test files.

option(ADFRIC_OWN_RUNNER "Use the project's own test runner even where pFUnit is installed" OFF)

set(PFUNIT_FOUND FALSE)
if(NOT ADFRIC_OWN_RUNNER)
  find_package(PFUNIT 4 QUIET)
endif()
if(PFUNIT_FOUND)
  message(STATUS "Tests run under pFUnit ${PFUNIT_VERSION}")
  return()
endif()
message(STATUS "Tests run under the project's own runner")
add_subdirectory("${PROJECT_SOURCE_DIR}/tests/runner" "${PROJECT_BINARY_DIR}/tests/runner")

# add_pfunit_ctest(<name> TEST_SOURCES <file.pf>... [OTHER_SOURCES <file>...] [LINK_LIBRARIES <target>...])
#
# Builds an executable of the test files and registers it as a test, as pFUnit's function does. A
# file is named relative to the current source folder, or absolutely if it was generated in the build tree.
function(add_pfunit_ctest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "TEST_SOURCES;OTHER_SOURCES;LINK_LIBRARIES")
  if(arg_UNPARSED_ARGUMENTS OR NOT arg_TEST_SOURCES)
    message(FATAL_ERROR "add_pfunit_ctest(${name}): known are TEST_SOURCES, OTHER_SOURCES and LINK_LIBRARIES, "
      "the first must not be empty; not understood: ${arg_UNPARSED_ARGUMENTS}")
  endif()

  set(sources "")
  set(suites "")
  foreach(file ${arg_TEST_SOURCES})
    get_filename_component(suite "${file}" NAME_WE)
    list(APPEND suites "${suite}_suite")
    adfric_translate_test("${file}" source)
    list(APPEND sources "${source}")
  endforeach()
  list(TRANSFORM suites REPLACE "(.+)" "   external :: \\1" OUTPUT_VARIABLE externals)
  list(TRANSFORM suites REPLACE "(.+)" "   call \\1()" OUTPUT_VARIABLE calls)
  # they call what is tested; half their time to compile goes into making them fast
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS "-O0;-g1")
  list(JOIN externals "\n" externals)
  list(JOIN calls "\n" calls)
  set(driver "${CMAKE_CURRENT_BINARY_DIR}/${name}_driver.f90")
  configure_file("${PROJECT_SOURCE_DIR}/tests/runner/driver.f90.in" "${driver}" @ONLY)

  set(modules "${CMAKE_CURRENT_BINARY_DIR}/mod/${name}")
  add_executable(${name} ${sources} ${arg_OTHER_SOURCES} "${driver}")
  set_target_properties(${name} PROPERTIES Fortran_MODULE_DIRECTORY "${modules}")
  target_include_directories(${name} PRIVATE "${modules}" "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${name} ${arg_LINK_LIBRARIES} adfric_funit)
  add_test(NAME ${name} COMMAND ${name} --verbose WORKING_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}")
endfunction()

# Have one test file translated to Fortran; the result is named as pFUnit names it.
function(adfric_translate_test file result)
  string(REGEX REPLACE "\\.pf$" ".F90" source "${file}")
  if(NOT IS_ABSOLUTE "${file}")
    set(file "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    set(source "${CMAKE_CURRENT_BINARY_DIR}/${source}")
  endif()
  string(FIND "${source}" "${PROJECT_BINARY_DIR}/" position)
  if(NOT position EQUAL 0)
    message(FATAL_ERROR "${file}: name test files of the source tree relative to the current folder")
  endif()
  get_filename_component(base "${file}" NAME)
  get_filename_component(folder "${source}" DIRECTORY)
  file(MAKE_DIRECTORY "${folder}")
  add_custom_command(OUTPUT "${source}" COMMAND pf_preprocess "${file}" "${source}"
    DEPENDS "${file}" pf_preprocess COMMENT "Translating ${base}")
  set(${result} "${source}" PARENT_SCOPE)
endfunction()
