# SPDX-License-Identifier: GPL-3.0-or-later
# Take away the files of the last installation, which MANIFEST lists, and the folders of its own that are then empty.

if(NOT EXISTS "${MANIFEST}")
  message(FATAL_ERROR "nothing to take away: there is no ${MANIFEST}")
endif()
file(STRINGS "${MANIFEST}" files)
set(folders "")
foreach(file IN LISTS files)
  set(file "$ENV{DESTDIR}${file}")
  file(REMOVE "${file}")
  get_filename_component(folder "${file}" DIRECTORY)
  while(folder MATCHES "/adfric(/|$)")
    list(APPEND folders "${folder}")
    get_filename_component(folder "${folder}" DIRECTORY)
  endwhile()
endforeach()

# the inner ones first
list(REMOVE_DUPLICATES folders)
list(SORT folders ORDER DESCENDING)
foreach(folder IN LISTS folders)
  file(GLOB rest LIST_DIRECTORIES TRUE "${folder}/*" "${folder}/.*")
  if(NOT rest)
    file(REMOVE_RECURSE "${folder}")
  endif()
endforeach()
