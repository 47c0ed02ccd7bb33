# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a test program whose tests all pass (RIGHT) and one whose tests all fail (WRONG) and compares what they print
# with what they should; FILES are the test files of the latter, separated by commas.

execute_process(COMMAND "${RIGHT}" OUTPUT_VARIABLE output RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT output MATCHES "^\\.+[\n.]*\nTime: +[0-9.]+ seconds\n\n OK\n \\([0-9]+ tests\\)\n$")
  message(FATAL_ERROR "status ${status} of passing tests, which print\n${output}")
endif()

# Every line with an assertion must be reported, in order.
set(expected "")
string(REPLACE "," ";" FILES "${FILES}")
foreach(path ${FILES})
  get_filename_component(name "${path}" NAME)
  file(READ "${path}" text)
  string(REPLACE "#" "" text "${text}")
  string(REPLACE "@assert" "#" text "${text}")
  string(REGEX REPLACE "[^#\n]" "" text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    if(line STREQUAL "#")
      list(APPEND expected "${name}:${number}")
    endif()
  endforeach()
endforeach()

execute_process(COMMAND "${WRONG}" OUTPUT_VARIABLE output RESULT_VARIABLE status)
if(NOT status EQUAL 2)
  message(FATAL_ERROR "status ${status} of failing tests, which print\n${output}")
endif()
# An open bracket would glue the elements of a list together.
string(REPLACE "  Location: \n[" "#" reported "${output}")
string(REGEX MATCHALL "#[^]\n]*" reported "${reported}")
list(TRANSFORM reported REPLACE "#" "")
list(LENGTH expected n)
if(NOT reported STREQUAL expected)
  message(FATAL_ERROR "expected failures at\n${expected}\nbut reported are\n${reported}\nin\n${output}")
endif()
if(NOT output MATCHES "\nTests run: ${n}, Failures: ${n}, Errors: 0\n")
  message(FATAL_ERROR "the last lines do not count ${n} tests and failures:\n${output}")
endif()

# A few texts.
foreach(text
    "Failure\n in: \nwrong_suite.test_true\n  Location: \n[wrong.pf:14]\nAssertTrue failure\n"
    "the second element\n"
    "order\nArrays not conformable\n    Expected shape: [2,2]\n      Actual shape: [3,3]\n"
    "case 1\nAssertLessThan failure:\n          Left: <1>\n         Right: <0>\n"
    "      Expected: <2>\n        Actual: <-1>\n      at index: [2,3]\n")
  string(FIND "${output}" "${text}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "missing in the report:\n${text}\nThe report:\n${output}")
  endif()
endforeach()
