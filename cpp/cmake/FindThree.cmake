# three.js as Debian's libjs-three has it: Three_LIBRARY, Three_CONTROLS.
find_file(Three_LIBRARY three.min.js PATH_SUFFIXES share/javascript/three)
find_file(Three_CONTROLS OrbitControls.js
  PATH_SUFFIXES share/javascript/three/examples/js/controls)
mark_as_advanced(Three_LIBRARY Three_CONTROLS)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Three DEFAULT_MSG Three_LIBRARY Three_CONTROLS)
