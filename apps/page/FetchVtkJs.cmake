# Puts vtk.js and its licence into a folder: vesicle_fetch_vtk_js(<folder> <result variable>). One
# pinned version comes from npm and is taken only if it is the very one that is expected. The result is
# empty when all is there, and otherwise says what is missing.
set(vtk_js_version 37.3.1)
set(vtk_js_sha512
  6535ddb24e70da966c9c7a8a585e841de3dc0cebdabecc057c68bf960044ea17b05e4e6e392972433ba2fb5c01429819cb8d852e37e766bec41ecb1ad31b9533)

function(vesicle_fetch_vtk_js folder result)
  set(${result} "" PARENT_SCOPE)
  set(archive "${CMAKE_BINARY_DIR}/vtk.js-${vtk_js_version}.tgz")
  if(NOT EXISTS "${archive}")
    find_program(NPM_PROGRAM npm NO_CACHE)
    if(NOT NPM_PROGRAM)
      set(${result} "the program npm is not installed (Debian: apt-get install npm)" PARENT_SCOPE)
      return()
    endif()
    execute_process(
      COMMAND "${NPM_PROGRAM}" pack "vtk.js@${vtk_js_version}" --silent
      WORKING_DIRECTORY "${CMAKE_BINARY_DIR}" TIMEOUT 120
      RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE complaint)
    if(failed OR NOT EXISTS "${archive}")
      set(${result} "npm could not fetch vtk.js@${vtk_js_version}: ${complaint}" PARENT_SCOPE)
      return()
    endif()
  endif()
  file(SHA512 "${archive}" found)
  if(NOT found STREQUAL vtk_js_sha512)
    file(REMOVE "${archive}")
    message(FATAL_ERROR "vtk.js@${vtk_js_version} is not the expected file: its SHA-512 is ${found}")
  endif()
  file(ARCHIVE_EXTRACT INPUT "${archive}" DESTINATION "${CMAKE_BINARY_DIR}/vtk.js"
    PATTERNS package/vtk.js package/LICENSE)
  configure_file("${CMAKE_BINARY_DIR}/vtk.js/package/vtk.js" "${folder}/vtk.js" COPYONLY)
  configure_file("${CMAKE_BINARY_DIR}/vtk.js/package/LICENSE" "${folder}/vtk.js-LICENSE" COPYONLY)
endfunction()
