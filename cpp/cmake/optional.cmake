# certet_find(<part> <arguments of find_package...>)
# Sets CERTET_HAS_<part> by the switch CERTET_<part>.
function(certet_find part)
  set(found FALSE)
  if(NOT CERTET_${part} STREQUAL "OFF")
    find_package(${ARGN} QUIET)
    if(${ARGV1}_FOUND)
      set(found TRUE)
    elseif(CERTET_${part} STREQUAL "ON")
      message(FATAL_ERROR "CERTET_${part} is ON, but ${ARGV1} was not found")
    endif()
  endif()
  set(CERTET_HAS_${part} ${found} PARENT_SCOPE)
  message(STATUS "certet: ${part} ${found}")
endfunction()

# What every target of the project is compiled with.  Contraction to fused
# multiply-add would make results depend on compiler and machine; a square root
# that need not set errno vectorises.
add_library(certet_flags INTERFACE)
target_compile_options(certet_flags INTERFACE
  -Wall -Wextra -Wconversion -ffp-contract=off -fno-math-errno)

# Ranks in bit sets are counted by the popcount instruction, which every x86-64
# machine since 2009 has.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  target_compile_options(certet_flags INTERFACE -march=x86-64-v2)
endif()
