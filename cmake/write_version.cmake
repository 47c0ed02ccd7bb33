# SPDX-License-Identifier: GPL-3.0-or-later
# Write the version of the program and the revision of its source into RESULT, if they have changed.

set(ADFRIC_GIT_REVISION "unknown")
if(GIT)
  execute_process(COMMAND "${GIT}" describe --always --dirty --abbrev=12 WORKING_DIRECTORY "${FOLDER}"
    OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(ADFRIC_GIT_REVISION "${revision}")
  endif()
endif()
configure_file("${TEMPLATE}" "${RESULT}" @ONLY)
