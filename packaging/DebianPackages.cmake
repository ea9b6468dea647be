# Packages for Debian 12, split as Debian does: `cpack --config <build>/CPackConfig.cmake -B packages`.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME vesicle)
set(CPACK_PACKAGE_VENDOR "the Vesicle authors")
set(CPACK_PACKAGE_CONTACT "the Vesicle authors <vesicle@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "lipid vesicles by the boundary element method, in VTK pipelines")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_COMPONENTS_ALL runtime development program)

set(library "libvesicle${VESICLE_SOVERSION}")
set(exactly "(= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "${library}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "VTK filters of vesicles: the libraries")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libvesicle-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${library} ${exactly}, libeigen3-dev, libfmt-dev, libhdf5-dev, libopenblas-dev, libspdlog-dev, libtbb-dev, libtomlplusplus-dev, libvtk9-dev, nlohmann-json3-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "VTK filters of vesicles: headers, static libraries, CMake package")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME vesicle)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${library} ${exactly}, libosmesa6")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS ffmpeg)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "the command that simulates vesicles, with movies and plots")

if(TARGET vesicle_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-vesicle)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${library} ${exactly}, python3-vtk9, libosmesa6")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS python3-numpy)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "vesicles and their VTK filters in Python")
endif()
include(CPack)
