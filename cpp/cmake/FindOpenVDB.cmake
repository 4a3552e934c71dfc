# OpenVDB as a library and its headers.  The search that comes with it stops the
# whole configuration where one of the libraries beneath it has no headers, even
# if it was asked to be quiet and these headers are not needed.
find_path(OpenVDB_INCLUDE_DIR openvdb/openvdb.h)
# OpenVDB's headers include Boost's.
find_path(OpenVDB_BOOST_INCLUDE_DIR boost/version.hpp)
find_library(OpenVDB_LIBRARY openvdb)
find_package(TBB QUIET)
find_package(Imath CONFIG QUIET)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenVDB
  REQUIRED_VARS OpenVDB_LIBRARY OpenVDB_INCLUDE_DIR OpenVDB_BOOST_INCLUDE_DIR
                TBB_FOUND Imath_FOUND)
mark_as_advanced(OpenVDB_INCLUDE_DIR OpenVDB_BOOST_INCLUDE_DIR OpenVDB_LIBRARY)
if(OpenVDB_FOUND AND NOT TARGET OpenVDB::openvdb)
  add_library(OpenVDB::openvdb UNKNOWN IMPORTED GLOBAL)  # the tests write volumes too
  set_target_properties(OpenVDB::openvdb PROPERTIES
    IMPORTED_LOCATION ${OpenVDB_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenVDB_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "TBB::tbb;Imath::Imath")
endif()
