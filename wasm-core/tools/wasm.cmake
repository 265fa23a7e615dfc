# <model>.wasm for each model (target `models`) and, for the bench alone, core-bench.wasm with all of them (target
# `core-bench`): standalone modules that export the functions of exports/panicle.h. The caller runs `_initialize` once.

# The header is the one list of exports.
file(STRINGS src/exports/panicle.h declarations REGEX "^[A-Za-z].* \\*?panicle_[a-z_]+\\(")
set(exports "")
foreach(declaration IN LISTS declarations)
  string(REGEX MATCH "panicle_[a-z_]+" name "${declaration}")
  list(APPEND exports "_${name}")
endforeach()
# What is asked of models that grow from texts alone.
set(exports_without_texts ${exports})
list(FILTER exports_without_texts EXCLUDE REGEX "_(compile|forget)$")
list(JOIN exports "," exports)
list(JOIN exports_without_texts "," exports_without_texts)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/exports/panicle.h)

# The stack's option changed its name in 3.1.25, its default from 5 MB to 64 kB in 3.1.27.
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.27)
  set(stack_option -sTOTAL_STACK=1048576)
else()
  set(stack_option -sSTACK_SIZE=1048576)
endif()

# emmalloc: 3 kB less than the default allocator, and no slower here. The second round of the optimizer, over flattened
# code, takes another 2 kB. Functions go into their only caller only where they are small: big ones there have so many locals
# that most take two bytes to name, and small ones stay out of line in more places: 6 kB of 146, for a fiftieth of the time.
# That nothing traps takes 2 kB: what cannot go on calls abort, which leaves through an import, and stays.
# Memory begins with 4 MB instead of 16, and grows as it is asked for: a tree of seven steps takes 2, and each worker of a
# stand has a module of each model for itself.
# Sources are linked one by one in their libraries' order (panicle_library says why), of which nothing unused is kept.
function(panicle_wasm name library exported)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE ${library})
  set_target_properties(${name} PROPERTIES SUFFIX .wasm)
  target_link_options(${name} PRIVATE
    -O3 -sBINARYEN_EXTRA_PASSES=--flatten,--rereloop,-O3,-O3,--one-caller-inline-max-function-size=30,--flexible-inline-max-function-size=8,--traps-never-happen --no-entry -sMALLOC=emmalloc -sSTANDALONE_WASM -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=4194304 -sMAXIMUM_MEMORY=2147483648 ${stack_option}
    -sEXPORTED_FUNCTIONS=${exported} --js-library ${CMAKE_SOURCE_DIR}/tools/host.js)
endfunction()

file(WRITE ${CMAKE_BINARY_DIR}/empty.cpp "")
foreach(module IN LISTS modules)
  panicle_linked(panicle_linked_${module} no_texts ${models_of_${module}})
  set(exported "${exports_without_texts}")
  set(parts exports linked_${module})
  foreach(model IN LISTS models_of_${module})
    file(GLOB texts CONFIGURE_DEPENDS grammars/${model}/*.lsys grammars/${model}/*.growth)
    if(texts)
      set(exported "${exports}")
    endif()
    list(APPEND parts model_${model})
  endforeach()
  if(module STREQUAL particles)
    list(APPEND parts model_particles)
  endif()
  set(earlier ${rooms})
  list(REVERSE earlier)
  set(objects "")
  foreach(part IN LISTS parts earlier)
    list(APPEND objects $<TARGET_OBJECTS:panicle_${part}>)
  endforeach()
  panicle_wasm(${module} panicle_linked_${module} "${exported}" ${objects})
endforeach()
add_custom_target(models DEPENDS ${modules})

# The model that tests add.
panicle_linked(panicle_linked_toy no_texts toy)
panicle_wasm(toy panicle_linked_toy "${exports}" ${CMAKE_BINARY_DIR}/empty.cpp)
set_target_properties(toy PROPERTIES EXCLUDE_FROM_ALL ON)

file(GLOB bench_sources CONFIGURE_DEPENDS bench/*.cpp)
if(bench_sources)
  # Functions of the bench are marked EMSCRIPTEN_KEEPALIVE (or __attribute__((export_name))) where they stand.
  panicle_wasm(core-bench panicle_core "${exports}" ${bench_sources})
  set_target_properties(core-bench PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
