# cpack -G DEB: the packages certet (the program) and libcertet-dev (headers and
# libraries).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME certet)
set(CPACK_PACKAGE_VENDOR certet)
set(CPACK_PACKAGE_CONTACT "The certet developers <certet@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME certet)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION "tetrahedral meshes with proven angles
 certet fills a shape, be it a segmented image, a grayscale image or a formula,
 with tetrahedra whose dihedral angles lie within proven bounds.")
set(CPACK_DEBIAN_COMMAND_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libcertet-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "tetrahedral meshes with proven angles (development)
 Headers and libraries of certet, a mesher whose tetrahedra have dihedral angles
 within proven bounds.")
set(needs "libstdc++6")
foreach(pair TBB=libtbb-dev "ITK=libinsighttoolkit5-dev, libtiff-dev" MUPARSER=libmuparser-dev)
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 part)
  list(GET pair 1 package)
  if(NOT CERTET_${part} STREQUAL "OFF" AND CERTET_HAS_${part})
    string(APPEND needs ", ${package}")
  endif()
endforeach()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${needs}")
include(CPack)
