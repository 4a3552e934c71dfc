# What is installed of the library: its core and its components, each with an
# export set of its own, so that who asks for one need not have what another
# one is made of.
include(GNUInstallDirs)

# certet_component(<target> <name> [WHERE <part>] [NEEDS "<arguments of find_dependency>"...]
#   [LINKS <option>...])
# Makes the target certet::<name>, in this build as in an installation.  NEEDS
# are looked for where a program links the static library, and LINKS are what
# pkg-config tells of them; WHERE a part is not there, nothing is needed.
function(certet_component target name)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "WHERE" "NEEDS;LINKS")
  if(arg_WHERE AND NOT CERTET_HAS_${arg_WHERE})
    set(arg_NEEDS "")
    set(arg_LINKS "")
  endif()
  if(NOT TARGET certet::${name})
    add_library(certet::${name} ALIAS ${target})
  endif()
  set_target_properties(${target} PROPERTIES
    POSITION_INDEPENDENT_CODE ON  # modules of Python, plugins
    EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set_property(GLOBAL APPEND PROPERTY CERTET_COMPONENTS ${name})
  set_property(GLOBAL PROPERTY CERTET_TARGET_OF_${name} ${target})
  set_property(GLOBAL PROPERTY CERTET_NEEDS_OF_${name} "${arg_NEEDS}")
  list(JOIN arg_LINKS " " links)
  set_property(GLOBAL PROPERTY CERTET_PC_PRIVATE_OF_${name} "${links}")
endfunction()
