# cmake -DPROGRAM=FILE -P links_no_vtk.cmake: fails where the program needs a library of VTK.
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${PROGRAM}"
  RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing)
if(missing OR NOT found MATCHES "libtbb")
  message(FATAL_ERROR "${PROGRAM} needs ${found}; missing: ${missing}")
endif()
set(vtk ${found})
list(FILTER vtk INCLUDE REGEX "/lib(vtk|Vesicle)")
if(vtk)
  message(FATAL_ERROR "${PROGRAM} links VTK: ${vtk}")
endif()
